// SPDX-License-Identifier: MIT
// Plays effects like a game's on the emulated board: play.mjs MINUTES [SEED], in the ball's time, with the variables of run.sh. Prints figures
// once a minute. Exit: 0, 1 the board tripped, was lost or was reset, 64 usage.
import { pathToFileURL } from 'node:url';
import { DaemonOnBoard } from './daemon.mjs';

const kDirections = ['front', 'back', 'left', 'right', 'up', 'down'];

/** Repeatable pseudo-random numbers from 0 to 1 (a linear congruential generator, Numerical Recipes). */
function random(seed) {
  let state = seed >>> 0;
  return () => (state = (Math.imul(state, 1664525) + 1013904223) >>> 0) / 2 ** 32;
}

/** The next effect of the game: short and strong, long and weak, or nearly none for a while. */
function choose(next) {
  const direction = kDirections[Math.floor(next() * kDirections.length)];
  const kind = next();
  if (kind < 0.4) return ['effect.pulse', { direction, current_a: 4 + 11 * next(), duration_ms: Math.round(20 + 180 * next()) }];
  if (kind < 0.55) return ['effect.circle', { axis: direction, current_a: 3 + 5 * next(), duration_ms: Math.round(300 + 900 * next()) }];
  if (kind < 0.75) {
    const duration_ms = Math.round(100 + 700 * next());
    return ['effect.vibrate', { direction, frequency_hz: 20 + 180 * next(), current_a: 2 + 6 * next(), duration_ms }];
  }
  return ['effect.pulse', { direction, current_a: 0.5, duration_ms: Math.round(200 + 1300 * next()) }];
}

/** Plays for `minutes`; returns the figures. `report(figures)` is called once a minute of the ball's time. */
export async function play(daemon, minutes, { seed = 1, report = () => {} } = {}) {
  const { ball } = daemon;
  const next = random(seed);
  const begun = await daemon.state('armed');
  const figures = { minutes: 0, effects: 0, trips: 0, hottest_c: 0, true_hottest_c: 0 };
  const ended = ball.events(['effect_ended']);
  for (let reported = 0; figures.minutes < minutes && figures.trips === 0; ++figures.effects) {
    const over = ended.next();
    await ball.call(...choose(next));
    await over;
    const status = await ball.status();
    const truth = await ball.call('sim.truth');
    if (status.last_trip !== null) Object.assign(figures, { trips: 1, reason: status.last_trip.reason });
    figures.minutes = (status.time_ns - begun.time_ns) / 60e9;
    figures.hottest_c = Math.max(figures.hottest_c, status.temperature_c.model ?? 0);
    figures.true_hottest_c = Math.max(figures.true_hottest_c, ...truth.coils_c);
    Object.assign(figures, { frames: status.link.frames_out, lost: status.link.lost - begun.link.lost, errors: status.link.errors, skipped: status.loop.skipped });
    if (figures.minutes < reported + 1) continue;
    reported = Math.floor(figures.minutes);
    report(figures);
  }
  await ended.return();
  figures.resets = daemon.trace().filter((line) => line.event === 'reset').length;
  return figures;
}

export const isFlawless = ({ trips, lost, errors, skipped, resets }) => [trips, lost, errors, skipped, resets].every((count) => count === 0);

if (import.meta.url === pathToFileURL(process.argv[1]).href) {
  const [minutes, seed] = process.argv.slice(2).map(Number);
  if (!(minutes > 0)) {
    console.error('play.mjs MINUTES [SEED]');
    process.exit(64);
  }
  const daemon = await DaemonOnBoard.start({ speed: 100 });
  const wall = Date.now();
  const print = (figures) => console.log(JSON.stringify({ ...figures, wall_minutes: (Date.now() - wall) / 60e3 }));
  try {
    const figures = await play(daemon, minutes, { seed, report: print });
    print(figures);
    process.exitCode = isFlawless(figures) ? 0 : 1;
    await daemon.stop();
  } finally {
    await daemon.close();
  }
}
