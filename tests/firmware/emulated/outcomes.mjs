// SPDX-License-Identifier: MIT
// A reporter of node:test for programs: one JSON line for each test that was run: {name, failure}; failure is null, or Node's failure type.
export default async function* outcomes(source) {
  for await (const { type, data } of source) {
    if ((type !== 'test:pass' && type !== 'test:fail') || data.skip !== undefined) continue;
    const error = data.details?.error;
    yield `${JSON.stringify({ name: data.name, failure: type === 'test:fail' ? error?.failureType ?? 'unknown' : null, message: String(error?.cause?.message ?? error?.message ?? '') })}\n`;
  }
}
