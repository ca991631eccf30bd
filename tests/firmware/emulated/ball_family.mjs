// SPDX-License-Identifier: MIT
// A ball in its room, drawn from the family of all healthy ones (tests/rig/thermal_ball.h); its electronics are drawn by the simulator.
import { createHash } from 'node:crypto';

/** Repeatable pseudo-random numbers from 0 to 1; those of neighbouring seeds have nothing in common. */
function random(seed) {
  let count = 0;
  return () => createHash('sha256').update(`${seed} ${++count}`).digest().readUIntBE(0, 6) / 2 ** 48;
}

/** The device file of the drawn ball and the room's temperature, C. Uniformly within 3 % of the typical R25 and L, 2 % of the supply, 20 % of
 *  the thermal constants. */
export function drawBall(seed) {
  const next = random(seed);
  const off = (value, share) => value * (1 + share * (2 * next() - 1));
  const three = (value, share) => [0, 1, 2].map(() => off(value, share));
  const device = {
    name: 'drawn', r25_ohm: three(0.45, 0.03), inductance_h: off(0.0015, 0.03), supply_v: off(12, 0.02),
    thermal: {
      winding_j_k: three(58.81, 0.2), core_j_k: off(84.4, 0.2), winding_to_core_k_w: three(1, 0.2), core_to_room_fan_k_w: off(1.8, 0.2),
      core_to_room_still_k_w: off(5, 0.2), sensor_winding: Math.floor(3 * next()), sensor_lag_s: 1 + 2 * next(),
    },
  };
  return { device, ambientC: 18 + 14 * next() };
}
