// SPDX-License-Identifier: MIT
// Statistics of latencies for the tests' output.

export const percentile = (values, share) => values.sort((a, b) => a - b)[Math.min(values.length - 1, Math.floor(share * values.length))];

/** Lines of "from..to us  count" in steps of `width`. */
export const histogram = (values, width) => {
  const counts = [];
  for (const value of values) counts[Math.floor(value / width)] = (counts[Math.floor(value / width)] ?? 0) + 1;
  return Object.entries(counts).map(([bin, count]) =>
    `${`${bin * width}..${(Number(bin) + 1) * width}`.padStart(12)} us ${String(count).padStart(5)} ${'#'.repeat(Math.ceil((40 * count) / values.length))}`).join('\n');
};
