// SPDX-License-Identifier: MIT
// A forwarded address that stays the same while the programs behind it stop and start, as with ssh -L.
import net from "node:net";

export class Address {
  /** On a free port. */
  static async listen() {
    const address = new Address();
    address.sockets = new Set();
    address.server = net.createServer((client) => address.#forward(client));
    await new Promise((resolve) => address.server.listen(0, "127.0.0.1", resolve));
    address.port = address.server.address().port;
    address.url = `http://127.0.0.1:${address.port}`;
    return address;
  }

  /** New connections are forwarded to this daemon or game; while it does not listen, they are closed. */
  leadTo({ port }) {
    this.target = port;
  }

  #forward(client) {
    const server = net.connect(this.target, "127.0.0.1");
    for (const [from, to] of [[client, server], [server, client]]) {
      this.sockets.add(from);
      from.pipe(to);
      from.on("error", () => to.destroy());
      from.on("close", () => { this.sockets.delete(from); to.end(); });
    }
  }

  async end() {
    const closed = new Promise((resolve) => this.server.close(resolve));
    for (const socket of this.sockets) socket.destroy();
    await closed;
  }
}
