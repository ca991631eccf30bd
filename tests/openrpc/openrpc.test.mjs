// SPDX-License-Identifier: MIT
// What a client's author does with openrpc.json: validate it, resolve it, validate calls, generate types and a client.
import assert from 'node:assert/strict';
import { readFile, rm, writeFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { test } from 'node:test';

const packages = createRequire(`${process.env.HEDGEHOG_NODE_MODULES}/`);
const { MethodCallValidator, parseOpenRPCDocument, validateOpenRPCDocument } = packages('@open-rpc/schema-utils-js');
const { default: Typings } = packages('@open-rpc/typings');

const schema = new URL('../../protocol/schema/', import.meta.url);
const text = await readFile(new URL('openrpc.json', schema), 'utf8');
// Resolving modifies its argument.
const document = () => JSON.parse(text);

test('it is a valid OpenRPC document', () => {
  assert.equal(validateOpenRPCDocument(document()), true);
});

test('it is complete: every reference resolves', async () => {
  const resolved = await parseOpenRPCDocument(document());
  assert.equal(resolved.methods.length, document().methods.length);
  assert.ok(!JSON.stringify(resolved).includes('$ref'));
  for (const method of resolved.methods) {
    assert.equal(method.paramStructure, 'by-name', method.name);
    assert.equal(method.result.schema.type, 'object', method.name);
  }
});

test('each method has the errors that it answers with', async () => {
  const { methods } = await parseOpenRPCDocument(document());
  for (const { name, errors } of methods)
    assert.ok(errors.some(({ code, message }) => code === -32602 && message), name);
  const { errors } = methods.find(({ name }) => name === 'effect.play');
  assert.deepEqual(errors.find(({ code }) => code === -32008).data, { name: 'no_such_pattern' });
});

test('calls are validated as by the daemon', async () => {
  const calls = new MethodCallValidator(await parseOpenRPCDocument(document()));
  const validate = (method, params) => calls.validate(method, params);
  for (const direction of ['left', [0, 0, 1], { azimuth_deg: 90 }, { pin: 34 }])
    assert.deepEqual(validate('effect.pulse', { direction, level: 0.5 }), []);
  assert.deepEqual(validate('ping', {}), []);
  for (const wrong of [{}, { direction: 'sideways' }, { direction: [0, 1] }, { direction: 'left', level: 1.5 }])
    assert.equal(validate('effect.pulse', wrong).length, 1, JSON.stringify(wrong));
  assert.match(validate('effect.pluse', {}).message, /not found|does not exist/i);
});

test('required parameters come first, as the specification requires', () => {
  for (const { name, params } of document().methods) {
    const required = params.map((param) => param.required);
    assert.deepEqual(required, [...required].sort((a, b) => b - a), name);
  }
});

test('a generator makes types of it in every supported language', async () => {
  const typings = new Typings(await parseOpenRPCDocument(document()));
  for (const language of ['typescript', 'rust', 'go', 'python']) {
    const types = typings.toString(language);
    for (const name of ['Admission', 'Status', 'Description'])
      assert.match(types, new RegExp(`(interface|struct|class|type) ${name}\\b`), `${language}: ${name}`);
  }
});

/** The client that OpenRPC's generator makes in `folder`, compiled, and the errors of the compiler. */
const madeClient = async (folder) => {
  const ts = packages('typescript');
  await packages('@open-rpc/generator').default(
    { openrpcDocument: document(), outDir: folder, components: [{ type: 'client', language: 'typescript', name: 'hedgehog' }] });
  const file = join(folder, 'client/typescript/src/index.ts');
  // The generator uses the names of methods as names of members, in which TypeScript permits no dot.
  await writeFile(file, (await readFile(file, 'utf8')).replace(/^  public (\w+\.\w+):/gm, '  public "$1":'));
  const program = ts.createProgram([file], {
    strict: true, skipLibCheck: true, esModuleInterop: true, target: ts.ScriptTarget.ES2018, module: ts.ModuleKind.CommonJS,
    moduleResolution: ts.ModuleResolutionKind.Node10, types: ['node'], typeRoots: [join(process.env.HEDGEHOG_NODE_MODULES, '@types')], outDir: join(folder, 'built'),
  });
  const found = [...program.emit().diagnostics, ...ts.getPreEmitDiagnostics(program)];
  return { errors: found.map((one) => ts.flattenDiagnosticMessageText(one.messageText, '\n')), module: join(folder, 'built/index.js') };
};

/** A WebSocket that responds to each request with `result`, and the requests that it received. */
const mockServer = (result) => new Promise((resolve) => {
  const requests = [];
  const server = new (packages('ws').Server)({ host: '127.0.0.1', port: 0 }, () => resolve({ server, requests }));
  server.on('connection', (socket) => socket.on('message', (text) => {
    const request = JSON.parse(text);
    requests.push(request);
    socket.send(JSON.stringify({ jsonrpc: '2.0', id: request.id, result }));
  }));
});

test('a generator makes a client of it that compiles and calls', async (context) => {
  // Beside the packages, so that the client finds those that it needs.
  const folder = join(process.env.HEDGEHOG_NODE_MODULES, '../generated');
  await rm(folder, { recursive: true, force: true });
  const { errors, module } = await madeClient(folder);
  assert.deepEqual(errors, []);
  const { server, requests } = await mockServer({ version: '1.0.0' });
  context.after(() => server.close());
  const client = new (packages(module).default)({ transport: { type: 'websocket', host: '127.0.0.1', port: server.address().port } });
  context.after(() => client.rpc.close());
  assert.equal((await client.hello('made')).version, '1.0.0');
  assert.deepEqual((({ method, params }) => ({ method, params }))(requests[0]), { method: 'hello', params: { client: 'made' } });
  for (const { name } of document().methods) assert.equal(typeof client[name], 'function', name);
});
