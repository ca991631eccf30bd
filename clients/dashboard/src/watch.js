// SPDX-License-Identifier: MIT
// Says when the daemon is gone, silent or back. Nothing old is shown as if it were true.

const kSilentMs = 2000;
const kWelcomeMs = 4000;

/** Needs #gone (role=alert) on the page; sets data-link on the body: "open", "gone", "silent" or "locked". */
export function watch(link) {
  const banner = document.getElementById("gone");
  let was = "start";
  const show = (state, text) => {
    document.body.dataset.link = state;
    banner.hidden = text === "";
    banner.dataset.kind = state;
    if (banner.textContent !== text) banner.textContent = text;
  };
  link.addEventListener("open", () => {
    show("open", was === "gone" ? "The daemon is back." : "");
    if (was === "gone") setTimeout(() => document.body.dataset.link === "open" && show("open", ""), kWelcomeMs);
    was = "open";
  });
  link.addEventListener("gone", ({ detail }) => {
    const why = detail.reason ? ` (${detail.reason})` : "";
    show("gone", was === "start"
      ? `No daemon answers${why}. This page tries again by itself.`
      : `The daemon is gone${why}; the board has switched the coils off by itself. The values shown are out of date. This page comes back by itself.`);
    if (was === "open") was = "gone";
  });
  link.addEventListener("locked", () => show("locked", "This daemon needs a token."));
  setInterval(() => {
    if (!link.ready) return;
    const silent = link.silentMs() > kSilentMs;
    if (silent) show("silent", "The daemon is connected but silent. The values shown are out of date.");
    else if (document.body.dataset.link === "silent") show("open", "");
  }, 500);
}
