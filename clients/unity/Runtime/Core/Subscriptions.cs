// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;

namespace Hedgehog
{
    /// <summary>What a program subscribed to, for the next connection. The daemon keeps one subscription of each kind for a connection:
    /// of several requests of a kind the one that was sent last holds, in whichever order their responses come.</summary>
    internal sealed class Subscriptions
    {
        private const string Begin = ".subscribe";
        private const string End = ".unsubscribe";

        private readonly Dictionary<string, Change> newest = new Dictionary<string, Change>();
        private readonly Dictionary<string, SubscriptionEnded> ended = new Dictionary<string, SubscriptionEnded>();
        private long lastOrder;

        /// <summary>A request that was sent, and its place among all.</summary>
        internal sealed class Change
        {
            public readonly long Order;
            public readonly string Method;
            public readonly Params Parameters;

            public Change(long order, string method, Params parameters)
            {
                Order = order;
                Method = method;
                Parameters = parameters;
            }

            public bool Begins
            {
                get { return Method.EndsWith(Begin, StringComparison.Ordinal); }
            }

            /// <summary>null: it is about no subscription.</summary>
            public string Kind
            {
                get
                {
                    bool about = Begins || Method.EndsWith(End, StringComparison.Ordinal);
                    return about ? Method.Substring(0, Method.LastIndexOf('.')) : null;
                }
            }
        }

        /// <summary>A request that is sent now, for CarriedOut.</summary>
        public Change Sent(string method, Params parameters)
        {
            return new Change(++lastOrder, method, parameters);
        }

        /// <summary>The daemon has accepted it, or will not answer it.</summary>
        public void CarriedOut(Change change)
        {
            string kind = change.Kind;
            Change known;
            if (kind == null || (newest.TryGetValue(kind, out known) && known.Order > change.Order)) return;
            newest[kind] = change;
            ended.Remove(kind);
        }

        /// <summary>What a new connection has to ask for, in the order in which it was subscribed to.</summary>
        public List<Change> Current()
        {
            var current = new List<Change>();
            foreach (var one in newest.Values)
                if (one.Begins) current.Add(one);
            current.Sort((one, other) => one.Order.CompareTo(other.Order));
            return current;
        }

        /// <summary>The daemon refuses one of Current: what has ended by that; null: the program has ended or replaced it meanwhile.
        /// </summary>
        public SubscriptionEnded Refused(Change renewal, Json error)
        {
            string kind = renewal.Kind;
            if (newest[kind] != renewal) return null;
            newest[kind] = new Change(renewal.Order, kind + End, null);
            ended[kind] = new SubscriptionEnded(renewal.Method, error);
            return ended[kind];
        }

        /// <summary>Why there is none of this kind any more; null: the daemon has not refused to renew it.</summary>
        public SubscriptionEnded EndOf(string kind)
        {
            SubscriptionEnded why;
            return kind != null && ended.TryGetValue(kind, out why) ? why : null;
        }
    }
}
