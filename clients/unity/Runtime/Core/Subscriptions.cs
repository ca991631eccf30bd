// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;

namespace Hedgehog
{
    /// <summary>What a program subscribed to, for the next connection. By method: the daemon keeps one of each kind.</summary>
    internal sealed class Subscriptions
    {
        private const string Begin = ".subscribe";
        private const string End = ".unsubscribe";

        private readonly List<KeyValuePair<string, Params>> asked = new List<KeyValuePair<string, Params>>();

        public IEnumerable<KeyValuePair<string, Params>> Asked
        {
            get { return asked; }
        }

        /// <summary>A request that was carried out.</summary>
        public void Note(string method, Params parameters)
        {
            bool begins = method.EndsWith(Begin, StringComparison.Ordinal);
            if (!begins && !method.EndsWith(End, StringComparison.Ordinal)) return;
            string subscription = method.Substring(0, method.LastIndexOf('.')) + Begin;
            asked.RemoveAll(one => one.Key == subscription);
            if (begins) asked.Add(new KeyValuePair<string, Params>(subscription, parameters));
        }
    }
}
