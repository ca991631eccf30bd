// SPDX-License-Identifier: MIT
// Third-party clients for any JSON-RPC server: the responses to their requests are as they expect.
import assert from 'node:assert/strict';
import { createRequire } from 'node:module';
import net from 'node:net';
import { createInterface } from 'node:readline';
import { after, before, test } from 'node:test';

import { Daemon } from '../web/daemon.mjs';

const packages = createRequire(`${process.env.HEDGEHOG_NODE_MODULES}/`);
const kPulse = { direction: 'left', current_a: 5, duration_ms: 50 };
let daemon;
before(async () => { daemon = await Daemon.start(); });
after(() => daemon.end());

test('jayson calls a line at a time, alone and in a batch', async () => {
  const client = packages('jayson/promise').Client.tcp({ host: '127.0.0.1', port: daemon.tcp });
  assert.ok((await client.request('ping', {})).result.time_ns > 0);
  const pulse = await client.request('effect.pulse', { ...kPulse, on_close: 'finish' });
  assert.equal(pulse.result.accepted, true);
  assert.equal((await client.request('no.such', {})).error.code, -32601);
  assert.equal((await client.request('effect.pulse', ['left'])).error.code, -32602);
  const responses = await client.request([client.request('ping', {}, undefined, false), client.request('no.such', {}, undefined, false)]);
  assert.deepEqual(responses.map((response) => response.error?.code ?? 'result'), ['result', -32601]);
});

test('json-rpc-2.0 calls, fails, batches and is notified', async (context) => {
  const { JSONRPCClient, JSONRPCServer, JSONRPCServerAndClient } = packages('json-rpc-2.0');
  const socket = net.connect(daemon.tcp, '127.0.0.1');
  context.after(() => socket.destroy());
  const peer = new JSONRPCServerAndClient(
    new JSONRPCServer(), new JSONRPCClient((request) => { socket.write(`${JSON.stringify(request)}\n`); }));
  createInterface({ input: socket }).on('line', (line) => peer.receiveAndSend(JSON.parse(line)));
  const ended = new Promise((resolve) => peer.addMethod('event', (event) => event.type === 'effect_ended' && resolve(event)));
  assert.ok((await peer.request('hello', { client: 'json-rpc-2.0' })).limits.current_a > 0);
  await peer.request('events.subscribe', { types: ['effect_ended'] });
  await assert.rejects(() => peer.request('effect.pulse', { direction: 'sideways' }),
    (error) => error.code === -32602 && error.data.field === 'direction');
  peer.notify('effect.pulse', kPulse);
  assert.equal((await ended).reason, 'completed');
  const batch = ['1', 2].map((id) => ({ jsonrpc: '2.0', id, method: 'ping' }));
  const responses = await peer.client.requestAdvanced(batch);
  assert.deepEqual(responses.map(({ id }) => id), ['1', 2]);
});

test('rpc-websockets calls and is notified on /ws', async (context) => {
  const { Client } = packages('rpc-websockets');
  const client = new Client(`ws://127.0.0.1:${daemon.port}/ws`, { reconnect: false });
  context.after(() => client.close());
  await new Promise((resolve, reject) => client.on('open', resolve).on('error', reject));
  const ended = new Promise((resolve) => client.on('event', (event) => event.type === 'effect_ended' && resolve(event)));
  await client.call('events.subscribe', { types: ['effect_ended'] });
  const { effect } = await client.call('effect.pulse', kPulse);
  assert.equal((await ended).effect, effect);
  await assert.rejects(() => client.call('no.such', {}), (error) => error.code === -32601);
  await client.notify('effect.pulse', kPulse);
  assert.ok((await client.call('ping', {})).time_ns > 0);
});
