// SPDX-License-Identifier: MIT
// Delivery of the pages to a browser: compressed, cached as long as allowed, and in the colours that the user has
// chosen.
import assert from "node:assert/strict";
import http from "node:http";
import { test } from "node:test";
import { gunzipSync } from "node:zlib";

import { seriousFaults } from "./accessibility.mjs";
import { kDesktop } from "./browser.mjs";
import { daemon, open, page } from "./dashboard.mjs";
import { Racer } from "./racer.mjs";

/** The raw response, without decompression. */
const get = (url, headers = {}) => new Promise((resolve, reject) => {
  http.get(url, { headers }, (response) => {
    const parts = [];
    response.on("data", (part) => parts.push(part));
    response.on("end", () => resolve({ status: response.statusCode, headers: response.headers, body: Buffer.concat(parts) }));
  }).on("error", reject);
});

async function checkDelivery(url) {
  const gzip = { "accept-encoding": "deflate, gzip;q=0.9" };
  const index = await get(`${url}/`, gzip);
  assert.equal(index.headers["cache-control"], "no-cache");
  assert.equal(index.headers["content-encoding"], "gzip");
  assert.equal(index.headers.vary, "Accept-Encoding");
  const plain = await get(`${url}/`);
  assert.equal(plain.headers["content-encoding"], undefined);
  assert.deepEqual(gunzipSync(index.body), plain.body);
  assert.notEqual(index.headers.etag, plain.headers.etag);
  for (const [tag, more] of [[index.headers.etag, gzip], [plain.headers.etag, {}]]) {
    const again = await get(`${url}/`, { ...more, "if-none-match": tag });
    assert.equal(again.status, 304);
    assert.equal(again.body.length, 0);
    assert.equal(again.headers.etag, tag);
  }
  assert.equal((await get(`${url}/`, { "accept-encoding": "gzip;q=0" })).headers["content-encoding"], undefined);
  const [script, packed] = [await get(`${url}/main.js`), await get(`${url}/main.js`, gzip)];
  assert.ok(packed.body.length < 0.5 * script.body.length, `${packed.body.length} of ${script.body.length} bytes`);
  return script.body.toString();
}

test("the dashboard is sent packed, and what never changes is kept", async () => {
  const script = await checkDelivery(daemon.url);
  const [chunk] = /chunk-[0-9A-Z]{8}\.js/.exec(script);
  const response = await get(`${daemon.url}/${chunk}`, { "accept-encoding": "gzip" });
  assert.equal(response.headers["cache-control"], "public, max-age=31536000, immutable");
  assert.equal(response.headers["content-encoding"], "gzip");
});

/** Compressed size of a page and all that it loads. */
async function packedBytes(page) {
  const files = new Set([page]);
  let bytes = 0;
  // Files added during the loop are visited too.
  for (const file of files) {
    const { status, headers, body } = await get(`${daemon.url}/${file}`, { "accept-encoding": "gzip" });
    assert.equal(status, 200, file);
    assert.equal(headers["content-encoding"], "gzip", file);
    bytes += body.length;
    const text = gunzipSync(body).toString();
    const named = file.endsWith(".html") ? /(?<=(?:src|href)=")[\w-]+\.\w+(?=")/g : /chunk-[0-9A-Z]{8}\.js/g;
    for (const [name] of text.matchAll(named)) if (!name.endsWith(".html")) files.add(name);
  }
  assert.ok([...files].some((name) => name.startsWith("chunk-")), `${page} loads ${[...files]}`);
  return bytes;
}

for (const name of ["index.html", "orientation.html", "designer.html"])
  test(`${name} with all that it loads is at most 200 KiB`, async () => {
    const bytes = await packedBytes(name);
    assert.ok(bytes <= 200 * 1024, `${bytes} bytes`);
  });

test("the racing game is sent packed, and asked for again by its tag", async () => {
  const racer = await Racer.start();
  try {
    await checkDelivery(racer.url);
  } finally {
    await racer.end();
  }
});

const brightness = () => page.evaluate(() => {
  const [r, g, b] = getComputedStyle(document.body).backgroundColor.match(/[\d.]+/g).map(Number);
  return (r + g + b) / 765;
});

for (const [scheme, bright] of [["light", true], ["dark", false]]) {
  test(`the pages are ${scheme} for who wants them so, and can be read`, async () => {
    const racer = await Racer.start();
    try {
      for (const path of ["/", "/orientation.html", "/designer.html"]) {
        await page?.context().close();
        await open(path, { ...kDesktop, colorScheme: scheme });
        await checkColours(`${scheme} ${path}`, bright);
      }
      await page.goto(racer.url);
      await page.waitForSelector("body[data-link=open]");
      await checkColours(`${scheme} racer`, bright);
    } finally {
      await racer.end();
    }
  });
}

async function checkColours(name, bright) {
  const shown = await brightness();
  assert.ok(bright ? shown > 0.9 : shown < 0.15, `${name}: ${shown}`);
  assert.deepEqual(await seriousFaults(page), [], name);
}
