// SPDX-License-Identifier: MIT
using System.Collections.Generic;

namespace Hedgehog
{
    /// <summary>Notifications that nobody has fetched, in the order in which they came. Each kind has a queue of its own: a program may
    /// read one and not the other. One thread at a time.</summary>
    internal sealed class Notifications
    {
        /// Of each kind; the oldest are dropped.
        private const int MaxWaiting = 10000;

        private readonly Dictionary<string, Queue<Waiting>> queues = new Dictionary<string, Queue<Waiting>>
        {
            { "event", new Queue<Waiting>() }, { "telemetry", new Queue<Waiting>() }
        };
        /// Of methods that this version does not know.
        private readonly Queue<Waiting> others = new Queue<Waiting>();
        private long last;

        private struct Waiting
        {
            public long Number;
            public Notification Notification;
        }

        public void Add(Notification notification)
        {
            Queue<Waiting> queue;
            if (!queues.TryGetValue(notification.Method, out queue)) queue = others;
            if (queue.Count >= MaxWaiting) queue.Dequeue();
            queue.Enqueue(new Waiting { Number = ++last, Notification = notification });
        }

        /// <summary>The oldest of a method ("event"), null: of all. null: there is none.</summary>
        public Notification Take(string method)
        {
            Queue<Waiting> oldest = method == null ? others : queues[method];
            if (method == null)
                foreach (var queue in queues.Values)
                    if (queue.Count > 0 && (oldest.Count == 0 || queue.Peek().Number < oldest.Peek().Number)) oldest = queue;
            return oldest.Count > 0 ? oldest.Dequeue().Notification : null;
        }
    }
}
