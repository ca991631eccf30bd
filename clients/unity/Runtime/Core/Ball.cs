// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;

namespace Hedgehog
{
    /// <summary>A connection to the daemon whose calls wait for their response, never longer than `timeoutS`: for tools, tests
    /// and threads of their own; a frame loop takes AsyncBall. Any thread. Throws RequestError and NotConnected.</summary>
    public sealed class Ball : BlockingMethods, IDisposable
    {
        /// As good as for ever.
        private const double YearS = 3.2e7;

        private readonly AsyncBall ball;

        /// <summary>Connects. Parameters as those of AsyncBall.</summary>
        public Ball(string address = null, string name = "csharp", double timeoutS = 2.0, string token = null)
        {
            ball = new AsyncBall(address, name, timeoutS, token);
            try
            {
                ball.Open().GetAwaiter().GetResult();
            }
            catch (BallError)
            {
                ball.Dispose();
                throw;
            }
        }

        /// <summary>As AsyncBall.Reconnected.</summary>
        public event Action<Results.Hello> Reconnected
        {
            add { ball.Reconnected += value; }
            remove { ball.Reconnected -= value; }
        }

        /// <summary>As AsyncBall.SubscriptionEnded.</summary>
        public event Action<SubscriptionEnded> SubscriptionEnded
        {
            add { ball.SubscriptionEnded += value; }
            remove { ball.SubscriptionEnded -= value; }
        }

        public bool Connected
        {
            get { return ball.Connected; }
        }

        /// <summary>What the daemon said of itself: server, role, limits. null while not connected.</summary>
        public Results.Hello Hello
        {
            get { return ball.Hello; }
        }

        /// <summary>The result of a method.</summary>
        public override Json Call(string method, Params parameters = null)
        {
            return ball.Call(method, parameters).GetAwaiter().GetResult();
        }

        /// <summary>Sends without waiting for a response. False: nothing was sent, there is no daemon.</summary>
        public bool Notify(string method, Params parameters = null)
        {
            return ball.Notify(method, parameters);
        }

        /// <summary>As AsyncBall.Rumble.</summary>
        public bool Rumble(string slot, double strength, Direction direction = null, double? frequencyHz = null, Params others = null)
        {
            return ball.Rumble(slot, strength, direction, frequencyHz, others);
        }

        /// <summary>The next notification; null: none came in time.</summary>
        public Notification Next(double timeoutS = 0.0)
        {
            return NextOf(null, timeoutS);
        }

        /// <summary>Events as they come; ends when none came for `timeoutS` (null: never). null: of all types. Throws SubscriptionEnded
        /// when a new connection could not renew them.</summary>
        public IEnumerable<Results.Event> Events(string[] types = null, Scope? scope = null, double? timeoutS = null)
        {
            EventsSubscribe(types, scope);
            return EventsOf(timeoutS);
        }

        /// <summary>The status again and again. null: all its fields. Throws as Events.</summary>
        public IEnumerable<Results.Telemetry> Telemetry(double rateHz = 10.0, string[] fields = null, double? timeoutS = null)
        {
            TelemetrySubscribe(rateHz, fields);
            return TelemetryOf(timeoutS);
        }

        /// <summary>Ends the connection, and with it its effects.</summary>
        public void Dispose()
        {
            ball.Dispose();
        }

        private Notification NextOf(string kind, double? timeoutS)
        {
            Notification next;
            return ball.Next(out next, timeoutS ?? YearS, kind) ? next : null;
        }

        private IEnumerable<Results.Event> EventsOf(double? timeoutS)
        {
            const string Kind = "events";
            for (Notification next = NextOf(Kind, timeoutS); next != null; next = NextOf(Kind, timeoutS))
                if (next.Event != null) yield return next.Event;
        }

        private IEnumerable<Results.Telemetry> TelemetryOf(double? timeoutS)
        {
            const string Kind = "telemetry";
            for (Notification next = NextOf(Kind, timeoutS); next != null; next = NextOf(Kind, timeoutS))
                if (next.Telemetry != null) yield return next.Telemetry;
        }
    }
}
