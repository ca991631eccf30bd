// SPDX-License-Identifier: MIT
// Asks for the token of a daemon that carries out nothing without one.

const kForm = `
  <h2>This daemon needs a token</h2>
  <p id="token-problem" role="alert"></p>
  <label>Token <input name="token" type="password" autocomplete="off" spellcheck="false" placeholder="hht_…" required></label>
  <button type="submit">Connect</button>
  <p class="hint">The operator of the daemon makes one with <code>hedgehogctl token add</code>. It is kept until this tab is closed.</p>`;

/** Why the daemon has refused the token; empty: none was sent. */
function problem({ wrong, retryAfterMs }) {
  if (retryAfterMs > 0) return `Too many wrong tokens: the daemon accepts none for ${Math.ceil(retryAfterMs / 1000)} s.`;
  return wrong ? "The token is unknown or revoked." : "";
}

/** Adds a form to the page, shown while the link is locked. It leaves the stop button usable. */
export function askForToken(link) {
  const form = document.createElement("form");
  form.id = "token";
  form.hidden = true;
  form.setAttribute("aria-label", "Token");
  form.innerHTML = kForm;
  document.body.append(form);
  const input = form.elements.token;
  link.addEventListener("locked", ({ detail }) => {
    form.querySelector("#token-problem").textContent = problem(detail);
    form.hidden = false;
    input.value = "";
    input.focus();
  });
  link.addEventListener("open", () => { form.hidden = true; });
  form.addEventListener("submit", (event) => {
    event.preventDefault();
    link.unlock(input.value.trim());
  });
}
