// SPDX-License-Identifier: MIT
// HTTP server for the files of folders, on a free port, from which a page loads its modules.
import fs from "node:fs";
import http from "node:http";
import path from "node:path";

const TYPES = { ".html": "text/html", ".js": "text/javascript", ".mjs": "text/javascript" };

/** `folders`: path prefix → folder. */
export async function servePages(folders) {
  const server = http.createServer((request, response) => {
    const requested = path.posix.normalize(new URL(request.url, "http://localhost").pathname);
    const prefix = Object.keys(folders).find((one) => requested.startsWith(one));
    const file = prefix && path.join(folders[prefix], requested.slice(prefix.length) || "index.html");
    if (!file || !fs.existsSync(file)) {
      response.writeHead(404).end();
      return;
    }
    response.writeHead(200, { "Content-Type": TYPES[path.extname(file)] ?? "text/plain" });
    response.end(fs.readFileSync(file));
  });
  await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
  return {
    port: server.address().port,
    url: `http://127.0.0.1:${server.address().port}`,
    close() {
      server.close();
      server.closeAllConnections();
    },
  };
}
