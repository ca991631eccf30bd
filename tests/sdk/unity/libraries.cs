// SPDX-License-Identifier: MIT
// The C# library in the two ways in which programs use it, with the same functions.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Hedgehog;

internal static partial class Conformance
{
    private abstract class Library
    {
        private readonly List<Json> ended = new List<Json>();
        private int reconnections;

        /// What was reported, as a list of JSON.
        public string Ended
        {
            get { lock (ended) return Json.List(ended.ToArray()).ToString(); }
        }

        public int Reconnections
        {
            get { return Volatile.Read(ref reconnections); }
        }

        protected void Again(Hedgehog.Results.Hello hello)
        {
            Interlocked.Increment(ref reconnections);
        }

        /// A method that is called when a subscription has ended; null: none.
        public string AskedWhenEnded;
        protected readonly TaskCompletionSource<Json> AnswerWhenEnded = new TaskCompletionSource<Json>();

        protected void EndOf(SubscriptionEnded error)
        {
            lock (ended) ended.Add(Json.Of(error.Message));
            if (AskedWhenEnded != null) AnswerWhenEnded.SetResult(Call(AskedWhenEnded, null));
        }

        public abstract Json Open(string address, double timeoutS);
        public abstract void Close();
        public abstract Json Call(string method, Params given);
        public virtual void Ask(string method)
        {
            throw new NotSupportedException();
        }

        public virtual Json Answer()
        {
            return AnswerWhenEnded.Task.GetAwaiter().GetResult();
        }

        /// Of events or of telemetry, by its enumeration.
        public virtual Json NextOf(string kind)
        {
            throw new NotSupportedException();
        }

        public abstract bool Notify(string method, Params given);
        public abstract bool Rumble(string slot, double strength, Direction direction, Params others);
        public abstract Notification Next();
    }

    private sealed class BlockingLibrary : Library
    {
        private Ball ball;
        private IEnumerator<Hedgehog.Results.Event> events;
        private IEnumerator<Hedgehog.Results.Telemetry> telemetry;

        public Ball Ball
        {
            get { return ball; }
        }

        public override Json Open(string address, double timeoutS)
        {
            ball = new Ball(address, "conformance", timeoutS);
            ball.Reconnected += Again;
            ball.SubscriptionEnded += EndOf;
            return Json.Null;
        }

        public override void Close()
        {
            ball.Dispose();
        }

        public override Json Call(string method, Params given)
        {
            return ball.Call(method, given);
        }

        public override bool Notify(string method, Params given)
        {
            return ball.Notify(method, given);
        }

        public override bool Rumble(string slot, double strength, Direction direction, Params others)
        {
            return ball.Rumble(slot, strength, direction, null, others);
        }

        public override Notification Next()
        {
            return ball.Next(TimeoutS);
        }

        public override Json NextOf(string kind)
        {
            if (kind == "events")
            {
                events = events ?? ball.Events(timeoutS: TimeoutS).GetEnumerator();
                return events.MoveNext() ? events.Current.Json : Json.Null;
            }
            telemetry = telemetry ?? ball.Telemetry(5, timeoutS: TimeoutS).GetEnumerator();
            return telemetry.MoveNext() ? telemetry.Current.Json : Json.Null;
        }
    }

    /// As a frame loop uses it: asks again and again, and never waits.
    private sealed class TaskLibrary : Library
    {
        private AsyncBall ball;
        private Task<Json> asked;

        public override void Ask(string method)
        {
            asked = ball.Call(method, null);
        }

        public override Json Answer()
        {
            if (asked == null) return base.Answer();
            while (!asked.IsCompleted) Thread.Yield();
            return asked.GetAwaiter().GetResult();
        }

        public override Json Open(string address, double timeoutS)
        {
            ball = new AsyncBall(address, "conformance", timeoutS);
            ball.Reconnected += Again;
            ball.SubscriptionEnded += EndOf;
            ball.Open().GetAwaiter().GetResult();
            return Json.Null;
        }

        public override void Close()
        {
            ball.Dispose();
        }

        public override Json Call(string method, Params given)
        {
            var asked = ball.Call(method, given);
            while (!asked.IsCompleted) Thread.Yield();
            return asked.GetAwaiter().GetResult();
        }

        public override bool Notify(string method, Params given)
        {
            return ball.Notify(method, given);
        }

        public override bool Rumble(string slot, double strength, Direction direction, Params others)
        {
            return ball.Rumble(slot, strength, direction, null, others);
        }

        public override Notification Next()
        {
            Notification received;
            while (!ball.TryNext(out received)) Thread.Yield();
            return received;
        }
    }
}
