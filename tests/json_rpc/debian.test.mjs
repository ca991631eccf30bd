// SPDX-License-Identifier: MIT
// JSON-RPC clients packaged by Debian, as programs in their own languages.
import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { promisify } from 'node:util';

import { Daemon } from '../web/daemon.mjs';
import { eventually } from '../web/timeouts.mjs';

const run = promisify(execFile);
const here = (file) => fileURLToPath(new URL(file, import.meta.url));
let daemon;
before(async () => { daemon = await Daemon.start(); });
after(() => daemon.end());

test('aiorpcX calls, fails, batches and is notified over TCP', async () => {
  // Only Debian's Python finds Debian's modules.
  await run('/usr/bin/python3', ['-B', here('aiorpcx_client.py'), String(daemon.tcp)]);
});

test('libjson-rpc-cpp calls, fails and batches on the Unix socket', async () => {
  const earlier = await daemon.ended('completed');
  await run(process.env.HEDGEHOG_JSONRPCCPP_CLIENT, [`${daemon.home}/run/hedgehog/hedgehogd.sock`]);
  // The pulse of its call, and that of the notification in its batch.
  await eventually(async () => await daemon.ended('completed') >= earlier + 2);
  assert.equal(await daemon.ended('completed'), earlier + 2);
});
