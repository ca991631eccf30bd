// SPDX-License-Identifier: MIT
// The stop button: by click, by Escape, and by Space unless somebody came by the Tab key to a control that uses it.

const kPatienceMs = 2000;

/** Needs #stop and #unstopped (role=alert) on the page. `say(text, bad)`: one line for the person. */
export function stopButton(link, say) {
  const button = document.getElementById("stop");
  const failure = document.getElementById("unstopped");
  const fail = (text) => {
    failure.textContent = text;
    failure.hidden = text === "";
  };
  const stop = async () => {
    button.classList.add("pressed");
    let told = false;
    const unconfirmed = () => {
      button.classList.remove("pressed");
      if (!told) fail("The daemon does not confirm the stop. Its board switches the coils off 100 ms after its last set-point; to be sure, pull the plug.");
      told = true;
    };
    const patience = setTimeout(unconfirmed, kPatienceMs);
    try {
      await link.emergencyStop();
      fail("");
      say("coils off; latched until somebody arms the ball");
    } catch {
      unconfirmed();
    }
    clearTimeout(patience);
    button.classList.remove("pressed");
  };
  link.addEventListener("open", () => fail(""));
  button.addEventListener("click", stop);
  // A control that mouse or thumb left in focus must not keep Space.
  let tabbed = false;
  addEventListener("pointerdown", () => { tabbed = false; }, true);
  addEventListener("keydown", (event) => {
    if (event.key === "Tab") tabbed = true;
    const control = tabbed && event.target.closest?.("button, input:not([type=range]), select, summary");
    if (event.key !== "Escape" && (event.key !== " " || control)) return;
    event.preventDefault();
    // Some browsers press a button when the key goes up.
    if (!tabbed) document.activeElement?.blur();
    if (!event.repeat) stop();
  });
}
