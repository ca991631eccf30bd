// SPDX-License-Identifier: MIT
// What happened on the ball, newest first: what the daemon remembers, then what it tells. Trips, what else
// concerns the ball, derating, what recurs, and ends of effects have lines of their own, so that neither a game, nor a warm ball,
// nor a busy machine pushes news out.
import { contradiction, eventText } from "./words.js";

const kMeasurements = ["measurement_rejected", "measurement_accepted"];
const kLapses = ["overrun", "orientation_lost", "orientation_restored"];
/** Events of one of these types within a minute are one line. */
const kRecurring = [...kLapses, ...kMeasurements];
const kSeriesMs = 60_000;
const kDerating = ["derating_started", "derating_ended"];

const kKinds = [
  { limit: 4, params: { trips: true }, is: (event) => isTrip(event) },
  {
    limit: 5,
    params: { types: ["state_changed", "device_attached", "device_detached", "shutting_down"] },
    is: (event) => !isTrip(event) && !isEnd(event) && !recurs(event) && !derates(event) && event.type !== "effect_started",
  },
  { limit: 2, params: { types: kDerating }, is: (event) => derates(event) },
  { limit: 3, params: { types: kMeasurements }, is: (event) => kMeasurements.includes(event.type) },
  { limit: 2, params: { types: kLapses }, is: (event) => kLapses.includes(event.type) },
  { limit: 3, params: { types: ["effect_ended"] }, is: (event) => isEnd(event) && event.reason !== "replaced" },
];
/** Who played what, and where the recording of a trip is, only the history says; a recording may take seconds. */
const kNamesMs = 500;
const kMaxAttempts = 8;

const isTrip = (event) => event.type === "state_changed" && event.current_a !== undefined;
const derates = (event) => kDerating.includes(event.type);
const recurs = (event) => kRecurring.includes(event.type);
const isEnd = (event) => event.type === "effect_ended";
/** Of the same measurements, or of none. */
const agree = (a, b) => contradiction(a.disagreement) === contradiction(b.disagreement);
const same = (a, b) => a.type === b.type && a.time_ns === b.time_ns && a.effect === b.effect && agree(a, b);

function when(at) {
  const time = new Date(at);
  const clock = time.toLocaleTimeString("en-GB");
  const today = time.toDateString() === new Date().toDateString();
  return today ? clock : `${time.toLocaleDateString("en-CA")} ${clock}`;
}

/** The line that `event` is one more of; undefined: none. */
function seriesOf(event, events) {
  const from = Date.now() - kSeriesMs;
  const continues = (old) => old.type === event.type && agree(old, event) && Date.parse(old.last ?? old.at) >= from;
  return recurs(event) ? events.find(continues) : undefined;
}

/** `save(file)`: downloads a recording with the token; undefined: the browser can do it without. */
function item(event, save) {
  const line = document.createElement("li");
  const at = Object.assign(document.createElement("time"), { dateTime: event.at, textContent: when(event.at) });
  const words = Object.assign(document.createElement("span"), { textContent: eventText(event) });
  words.classList.toggle("bad", isTrip(event) || event.state === "tripped");
  if (event.recording) {
    const file = `${event.recording}.hhr`;
    const link = Object.assign(document.createElement("a"), { href: `recordings/${file}`, download: file, textContent: "recording" });
    link.title = `The last seconds before it: hedgehogd --replay ${file} reads it`;
    if (save) link.addEventListener("click", (click) => {
      click.preventDefault();
      save(file);
    });
    words.append(" · ", link);
  }
  line.append(at, words);
  return line;
}

/** Fills `list` from `link`. `showMessage(text, bad)`: one line for the person. */
export function eventList(list, link, showMessage) {
  const kinds = kKinds.map((kind) => ({ ...kind, events: [] }));
  let drawn = true;
  let naming = null;
  let attempts = 0;
  // The browser sends no Authorization for a link that is clicked.
  const save = async (file) => {
    try {
      const response = await fetch(`recordings/${file}`, { headers: { Authorization: `Bearer ${link.token}` } });
      if (!response.ok) throw new Error(`the daemon answers ${response.status}`);
      const url = URL.createObjectURL(await response.blob());
      Object.assign(document.createElement("a"), { href: url, download: file }).click();
      URL.revokeObjectURL(url);
    } catch (error) {
      showMessage(`${file} was not downloaded: ${error.message}`, true);
    }
  };
  const show = () => {
    if (!drawn) return;
    drawn = false;
    requestAnimationFrame(() => {
      drawn = true;
      const events = kinds.flatMap((kind) => kind.events);
      list.replaceChildren(...events.sort((a, b) => Date.parse(b.at) - Date.parse(a.at))
        .map((event) => item(event, link.token && save)));
    });
  };
  /** What the daemon remembers, behind what it has told and does not remember. */
  const load = async (kind) => {
    // Room for the trips among what concerns the ball.
    const { events } = await link.call("events.history", { ...kind.params, limit: 2 * kind.limit });
    const past = events.filter(kind.is).reverse();
    const recent = kind.events.filter((event) => event.fresh && !past.some((old) => same(event, old)));
    kind.events = [...recent, ...past].slice(0, kind.limit);
    show();
  };
  // A call that fails leaves what is there.
  const loadAll = (some) => Promise.allSettled(some.map(load));
  const isFresh = ({ events }) => events.some((event) => event.fresh);
  const reloadLater = () => {
    naming ??= setTimeout(async () => {
      naming = null;
      const [trips] = kinds;
      await loadAll(kinds.filter((kind) => isFresh(kind) || (kind === trips && attempts > 0)));
      if (trips.events[0] && !trips.events[0].recording && --attempts > 0) reloadLater();
    }, kNamesMs);
  };
  link.addEventListener("open", () => loadAll(kinds));
  link.addEventListener("gone", () => {
    for (const kind of kinds) kind.events = kind.events.map((event) => ({ ...event, fresh: false }));
  });
  link.addEventListener("event", ({ detail }) => {
    const kind = kinds.find(({ is }) => is(detail));
    if (!kind || kind.events.some((event) => same(event, detail))) return;
    const series = seriesOf(detail, kind.events);
    if (series) {
      series.count = (series.count ?? 1) + 1;
      series.last = new Date().toISOString();
      if (detail.skipped) series.skipped = (series.skipped ?? 0) + detail.skipped;
      show();
      return;
    }
    kind.events = [{ ...detail, at: new Date().toISOString(), fresh: true }, ...kind.events].slice(0, kind.limit);
    show();
    if (isTrip(detail)) attempts = kMaxAttempts;
    if (isTrip(detail) || isEnd(detail)) reloadLater();
  });
}
