// SPDX-License-Identifier: MIT
// The stop button: by click, by Escape always, and by Space while no control has the focus.

/** The answer may wait two seconds for the disk. */
const kTimeoutMs = 2500;
/** Space is theirs while they have the focus. */
const kControls = "a[href], button, input, select, textarea, summary, [contenteditable]";
/** A mouse or thumb that has pressed one of these does not leave the focus there. */
const kPressed = "button, summary, input[type=radio], input[type=checkbox]";

/** Needs #stop and #unstopped (role=alert) on the page. `showMessage(text, bad)`: one line for the person. */
export function stopButton(link, showMessage) {
  const button = document.getElementById("stop");
  const failure = document.getElementById("unstopped");
  const fail = (text) => {
    failure.textContent = text;
    failure.hidden = text === "";
  };
  const stop = async () => {
    button.classList.add("pressed");
    let reported = false;
    const unconfirmed = () => {
      button.classList.remove("pressed");
      if (!reported) fail("The daemon does not confirm the stop. Its board switches the coils off 100 ms after its last set-point; to be sure, pull the plug.");
      reported = true;
    };
    const timeoutId = setTimeout(unconfirmed, kTimeoutMs);
    try {
      const response = await link.emergencyStop();
      fail("");
      showMessage(response?.on_disk === false
        ? "coils off; not on disk yet, so the latch may be lost at a restart" : "coils off; latched until somebody arms the ball");
    } catch {
      unconfirmed();
    }
    clearTimeout(timeoutId);
    button.classList.remove("pressed");
  };
  link.addEventListener("open", () => fail(""));
  button.addEventListener("click", stop);
  addEventListener("click", (event) => {
    // A key that presses a control counts no clicks, and keeps the focus. A label gives it away only after this event.
    if (event.detail > 0) setTimeout(() => document.activeElement?.matches(kPressed) && document.activeElement.blur());
  });
  addEventListener("keydown", (event) => {
    if (event.key !== "Escape" && (event.key !== " " || event.target.closest?.(kControls))) return;
    event.preventDefault();
    if (!event.repeat) stop();
  });
}
