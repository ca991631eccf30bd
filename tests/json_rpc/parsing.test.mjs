// SPDX-License-Identifier: MIT
// Each document of JSONTestSuite sent to a real daemon: as a message, as the parameters of a request, and as an id.
import assert from 'node:assert/strict';
import { after, before, describe, test } from 'node:test';

import { Daemon } from '../web/daemon.mjs';
import { documents, is_refused, is_utf8, of_kind, unknown_rows } from './json_test_suite.mjs';
import { TcpWire, WebSocketWire } from './wire.mjs';

const kParseError = -32700;
const kInvalidRequest = -32600;
const kInvalidParams = -32602;
const kMaxId = 2 ** 53;
const kLineFeed = 0x0a;

let daemon;
before(async () => { daemon = await Daemon.start(); });
after(() => daemon.end());

const joined = (...parts) => Buffer.concat(parts.map((part) => Buffer.from(part)));
/** Without the document's last line feed, which would end the message on TCP. */
const as_params = ({ name, bytes }) =>
  joined(`{"jsonrpc":"2.0","id":${JSON.stringify(name)},"method":"ping","params":`,
    bytes.at(-1) === kLineFeed ? bytes.subarray(0, -1) : bytes, '}');

function expect_parse_error(responses, name) {
  assert.equal(responses.length, 1, `${name}: ${JSON.stringify(responses)}`);
  assert.equal(responses[0].id, null, name);
  assert.equal(responses[0].error?.code, kParseError, `${name}: ${JSON.stringify(responses)}`);
}

/** No document is a valid request, and an array is a batch of invalid ones; one document has an id. */
function expect_invalid_request(responses, { name, text }) {
  const value = JSON.parse(text.replace(/^\ufeff/, ''));
  const batch = Array.isArray(value) && value.length > 0;
  assert.equal(responses.length, 1, name);
  const errors = batch ? responses[0] : responses;
  assert.equal(errors.length, batch ? value.length : 1, name);
  for (const [i, { id, error }] of errors.entries()) {
    const request = batch ? value[i] : value;
    assert.deepEqual([id, error.code], [request?.id ?? null, kInvalidRequest], name);
  }
}

function expect_as_params(responses, { name, text }) {
  assert.equal(responses.length, 1, name);
  assert.equal(responses[0].id, name);
  if (text.trim() === '{}') assert.ok(responses[0].result.time_ns > 0, name);
  else assert.equal(responses[0].error?.code, kInvalidParams, name);
}

/** A valid id is returned unchanged; another value is parsed, and rejected as an invalid request. */
function expect_as_id(responses, value, name) {
  assert.equal(responses.length, 1, name);
  const is_id = typeof value === 'string' || value === null || Math.abs(typeof value === 'number' ? value : NaN) <= kMaxId;
  if (!is_id) {
    assert.deepEqual([responses[0].id, responses[0].error?.code], [null, kInvalidRequest], name);
    return;
  }
  assert.ok(responses[0].result.time_ns > 0, name);
  // -0 may be returned as 0.
  assert.ok(responses[0].id === value, `${name}: ${JSON.stringify(value)} became ${JSON.stringify(responses[0].id)}`);
}

/** An array of one element is replaced by it: most documents are arrays for compatibility with older JSON. */
function as_id({ text }) {
  const value = JSON.parse(text);
  if (!Array.isArray(value) || value.length !== 1) return { value, json: text };
  return { value: value[0], json: text.trim().slice(1, -1) };
}

test('the package has all documents, and README.md no others', () => {
  assert.deepEqual(['y', 'n', 'i'].map((kind) => of_kind(kind).filter(is_utf8).length), [95, 188, 35]);
  assert.deepEqual(unknown_rows, []);
});

const transports = [
  // On TCP a line feed ends a message.
  { transport: 'TCP', open: TcpWire.open, accepts: ({ bytes }) => !bytes.subarray(0, -1).includes(kLineFeed), on_bad_utf8: null },
  { transport: 'WebSocket', open: WebSocketWire.open, accepts: () => true, on_bad_utf8: 1007 },
];

for (const { transport, open, accepts, on_bad_utf8 } of transports) {
  describe(`on ${transport}`, () => {
    const selected = (kind) => of_kind(kind).filter(accepts);
    let wire;
    before(async () => { wire = await open(daemon); });
    after(() => wire.end());

    async function exchange(bytes) {
      const { responses, closed } = await wire.exchange(bytes);
      assert.equal(closed, null);
      return responses;
    }

    async function expect_refused(document) {
      for (const bytes of [document.bytes, as_params(document)]) {
        if (is_utf8(document) || on_bad_utf8 === null) {
          expect_parse_error(await exchange(bytes), document.name);
          continue;
        }
        assert.deepEqual(await wire.exchange(bytes), { responses: [], closed: on_bad_utf8 }, document.name);
        wire = await open(daemon);
      }
    }

    async function expect_read(document) {
      expect_invalid_request(await exchange(document.bytes), document);
    }

    test('what is JSON is read', async () => {
      for (const document of selected('y').filter((document) => !is_refused(document))) {
        await expect_read(document);
        expect_as_params(await exchange(as_params(document)), document);
        const { value, json } = as_id(document);
        const request = `{"jsonrpc":"2.0","id":${json},"method":"ping"}`;
        expect_as_id(await exchange(Buffer.from(request)), value, document.name);
      }
    });

    test('JSON beyond a documented limit is a parse error', async () => {
      for (const document of selected('y').filter(is_refused)) await expect_refused(document);
    });

    test('what is no JSON is a parse error, and the next request is answered', async () => {
      for (const document of selected('n')) await expect_refused(document);
    });

    test('what JSON leaves open is answered as README.md says', async () => {
      for (const document of selected('i')) await (is_refused(document) ? expect_refused(document) : expect_read(document));
    });
  });
}

test('as the first line on TCP it is answered if it begins as a request does; otherwise the connection is closed', async () => {
  for (const { name, bytes } of documents) {
    const wire = await TcpWire.open(daemon);
    const { responses, closed } = await wire.exchange(bytes);
    wire.end();
    const first = bytes.find((byte) => byte !== kLineFeed && byte !== 0x0d);
    // `undefined`: an empty document, after which the first byte is the ping's `{`.
    const begins_well = first === undefined || first === 0x5b || first === 0x7b;
    assert.equal(closed, begins_well ? null : 'connection', name);
    assert.equal(responses.length > 0, begins_well, name);
  }
});
