// SPDX-License-Identifier: MIT
// What happened on the ball, newest first: what the daemon remembers, then what it tells. Trips, what else
// concerns the ball, and ends of effects have lines of their own, so that no game pushes a trip out.
import { happening } from "./words.js";

const kKinds = [
  { limit: 4, ask: { trips: true }, is: (event) => isTrip(event) },
  {
    limit: 6,
    ask: { types: ["state_changed", "derating_started", "derating_ended", "device_attached", "device_detached",
      "orientation_lost", "orientation_restored", "overrun", "shutting_down"] },
    is: (event) => !isTrip(event) && !isEnd(event) && event.type !== "effect_started",
  },
  { limit: 4, ask: { types: ["effect_ended"] }, is: (event) => isEnd(event) && event.reason !== "replaced" },
];
/** Who played what, only the history says. */
const kNamesMs = 500;

const isTrip = (event) => event.type === "state_changed" && event.current_a !== undefined;
const isEnd = (event) => event.type === "effect_ended";
const same = (a, b) => a.type === b.type && a.time_ns === b.time_ns && a.effect === b.effect;

function when(at) {
  const time = new Date(at);
  const clock = time.toLocaleTimeString("en-GB");
  const today = time.toDateString() === new Date().toDateString();
  return today ? clock : `${time.toLocaleDateString("en-CA")} ${clock}`;
}

function item(event) {
  const line = document.createElement("li");
  const at = Object.assign(document.createElement("time"), { dateTime: event.at, textContent: when(event.at) });
  const words = Object.assign(document.createElement("span"), { textContent: happening(event) });
  words.classList.toggle("bad", isTrip(event) || event.state === "tripped");
  line.append(at, words);
  return line;
}

/** Fills `list` from `link`. */
export function happened(list, link) {
  const kinds = kKinds.map((kind) => ({ ...kind, events: [] }));
  let drawn = true;
  let naming = null;
  const show = () => {
    if (!drawn) return;
    drawn = false;
    requestAnimationFrame(() => {
      drawn = true;
      const events = kinds.flatMap((kind) => kind.events);
      list.replaceChildren(...events.sort((a, b) => Date.parse(b.at) - Date.parse(a.at)).map(item));
    });
  };
  /** What the daemon remembers, behind what it has told and does not remember. */
  const recall = async (kind) => {
    // Room for the trips among what concerns the ball.
    const { events } = await link.call("events.history", { ...kind.ask, limit: 2 * kind.limit });
    const past = events.filter(kind.is).reverse();
    const told = kind.events.filter((event) => event.fresh && !past.some((old) => same(event, old)));
    kind.events = [...told, ...past].slice(0, kind.limit);
    show();
  };
  // A call that fails leaves what is there.
  const recallAll = (some) => Promise.allSettled(some.map(recall));
  link.addEventListener("open", () => recallAll(kinds));
  link.addEventListener("gone", () => {
    for (const kind of kinds) kind.events = kind.events.map((event) => ({ ...event, fresh: false }));
  });
  link.addEventListener("event", ({ detail }) => {
    const kind = kinds.find(({ is }) => is(detail));
    if (!kind || kind.events.some((event) => same(event, detail))) return;
    kind.events = [{ ...detail, at: new Date().toISOString(), fresh: true }, ...kind.events].slice(0, kind.limit);
    show();
    if (isTrip(detail) || isEnd(detail)) {
      naming ??= setTimeout(() => {
        naming = null;
        recallAll(kinds.filter(({ events }) => events.some((event) => event.fresh)));
      }, kNamesMs);
    }
  });
}
