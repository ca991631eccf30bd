// SPDX-License-Identifier: MIT
// What a program subscribed to, for the next connection.
const BEGIN = ".subscribe";
const END = ".unsubscribe";

function kindOf({ method }) {
  const verb = [BEGIN, END].find((one) => method.endsWith(one));
  return verb && method.slice(0, -verb.length);
}

/**
 * The daemon keeps one subscription of each kind for a connection: of several requests of a kind the one that was sent last
 * holds, in whichever order their responses come.
 */
export class Subscriptions {
  #lastOrder = 0;
  /** By kind. */
  #newest = new Map();

  /** A request that is sent now, for `carriedOut`. */
  sent(method, params) {
    return { method, params: { ...params }, order: ++this.#lastOrder };
  }

  /** The daemon has accepted it, or will not answer it. */
  carriedOut(change) {
    const kind = kindOf(change);
    if (kind && !(this.#newest.get(kind)?.order > change.order)) this.#newest.set(kind, change);
  }

  /** What a new connection has to ask for. */
  current() {
    return [...this.#newest.values()].filter(({ method }) => method.endsWith(BEGIN));
  }

  /** The daemon has refused one of `current`. True: it has ended; false: the program has ended or replaced it meanwhile. */
  refused(renewal) {
    const kind = kindOf(renewal);
    if (this.#newest.get(kind) !== renewal) return false;
    this.#newest.set(kind, { ...renewal, method: kind + END });
    return true;
  }
}
