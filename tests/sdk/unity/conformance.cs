// SPDX-License-Identifier: MIT
// conformance.json against the C# library, blocking and as tasks: conformance.exe FOLDER. Exit: 0 all cases pass.
using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using System.Threading;
using System.Threading.Tasks;
using Hedgehog;

internal static class Conformance
{
    // Of calls; a case in which the daemon never answers takes so long.
    private const double PatienceS = 60.0;
    private const double SlowPatienceS = 3.0;
    private const string Slow = "a slow response ends the connection, the next call makes a new one";

    private static string folder;

    private static int Main(string[] arguments)
    {
        folder = arguments[0];
        bool well = true;
        Json cases = Json.Parse(File.ReadAllText(Path.Combine(folder, "conformance.json")))["cases"];
        for (int i = 0; i < cases.Count; ++i)
            foreach (bool blocking in new[] { true, false })
            {
                Json one = cases[i];
                string name = one["name"].Text;
                string library = blocking ? "C# Ball" : "C# AsyncBall";
                if (one["without"].ToString().Contains("\"" + library + "\"")) continue;
                bool passed = Check.Run(library + ": " + name, () => Play(one, blocking));
                Report(library, name, passed);
                well &= passed;
            }
        return well ? 0 : 1;
    }

    /// For the table of run.sh.
    private static void Report(string library, string name, bool passed)
    {
        string table = Environment.GetEnvironmentVariable("HEDGEHOG_CONFORMANCE_TABLE");
        if (!string.IsNullOrEmpty(table)) File.AppendAllText(table, library + "\t" + name + "\t" + (passed ? "ok" : "failed") + "\n");
    }

    private static void Play(Json one, bool blocking)
    {
        string name = one["name"].Text;
        using (var daemon = new Process())
        {
            daemon.StartInfo = new ProcessStartInfo("python3", "\"" + Path.Combine(folder, "fake_daemon.py") + "\" \"" + name + "\"")
            {
                UseShellExecute = false, RedirectStandardOutput = true, RedirectStandardError = true
            };
            daemon.Start();
            string address = "127.0.0.1:" + daemon.StandardOutput.ReadLine().Trim();
            Json steps = one["client"];
            double patienceS = name == Slow ? SlowPatienceS : PatienceS;
            Library library = blocking ? (Library)new BlockingLibrary() : new TaskLibrary();
            if (steps[0].Has("open"))
            {
                Outcome(steps[0], () => library.Open(address, patienceS));
            }
            else
            {
                library.Open(address, patienceS);
                for (int i = 0; i < steps.Count; ++i) Step(library, steps[i]);
                library.Close();
            }
            string errors = daemon.StandardError.ReadToEnd();
            daemon.WaitForExit();
            Check.Equal("", errors, "the daemon's errors");
            Check.Equal(0, daemon.ExitCode, "the daemon's exit");
        }
    }

    private static void Step(Library library, Json step)
    {
        if (step.Has("call"))
        {
            Json result = Outcome(step, () => library.Call(step["call"].Text, ParamsOf(step["params"])));
            if (step.Has("result")) Check.Equal(step["result"].ToString(), result.ToString(), "the result");
        }
        else if (step.Has("call_again"))
        {
            Check.Equal(step["result"].ToString(), Again(library, step["call_again"].Text).ToString(), "the result");
        }
        else if (step.Has("ask"))
        {
            library.Ask(step["ask"].Text);
        }
        else if (step.Has("answered"))
        {
            Check.Equal(step["result"].ToString(), library.Answer().ToString(), "the response");
        }
        else if (step.Has("subscriptions_ended"))
        {
            Check.Equal(step["subscriptions_ended"].ToString(), library.Ended, "subscriptions that have ended");
        }
        else if (step.Has("notify"))
        {
            Check.That(library.Notify(step["notify"].Text, ParamsOf(step["params"])), "notified");
        }
        else if (step.Has("rumble"))
        {
            Check.That(library.Rumble(step["rumble"].Text, step["strength"].Number, step["direction"].Text, ParamsOf(step["params"])), "rumbled");
        }
        else if (step.Has("reconnected"))
        {
            Check.Equal((int)step["reconnected"].Integer, library.Reconnections, "connections but the first");
        }
        else
        {
            Notification received = library.Next();
            Check.Equal(step["notification"].Text, received.Method, "the notification");
            Check.Equal(step["params"].ToString(), received.Params.ToString(), "its parameters");
        }
    }

    /// Result of the action, which has to end as the step says.
    private static Json Outcome(Json step, Func<Json> action)
    {
        if (step.Has("failure"))
        {
            var lost = Check.Throws<NotConnected>(() => action());
            Check.That(lost.Message.Contains(step["says"].Text), lost.Message);
            return Json.Null;
        }
        if (step.Has("error"))
        {
            var refused = Check.Throws<RequestError>(() => action());
            Json expected = step["error"];
            Check.Equal((int)expected["code"].Integer, refused.Code, "the code");
            Check.Equal(expected["name"].Text, refused.Name, "the name");
            Check.Equal(expected["message"].Text, refused.Message, "the message");
            Check.Equal(expected["field"].Text, refused.Data.Field, "the field");
            return Json.Null;
        }
        return action();
    }

    private static Json Again(Library library, string method)
    {
        for (;;)
        {
            try
            {
                return library.Call(method, null);
            }
            catch (NotConnected lost)
            {
                Thread.Sleep((int)Math.Ceiling(1000.0 * lost.RetryAfterS));
            }
        }
    }

    private static Params ParamsOf(Json json)
    {
        var given = new Params();
        for (int i = 0; i < json.Count; ++i) given.Set(json.NameAt(i), json[i]);
        return given;
    }

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

        protected void EndOf(SubscriptionEnded error)
        {
            lock (ended) ended.Add(Json.Of(error.Message));
        }

        public abstract Json Open(string address, double patienceS);
        public abstract void Close();
        public abstract Json Call(string method, Params given);
        public virtual void Ask(string method)
        {
            throw new NotSupportedException();
        }
        public virtual Json Answer()
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

        public override Json Open(string address, double patienceS)
        {
            ball = new Ball(address, "conformance", patienceS);
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
            return ball.Next(PatienceS);
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
            while (!asked.IsCompleted) Thread.Yield();
            return asked.GetAwaiter().GetResult();
        }

        public override Json Open(string address, double patienceS)
        {
            ball = new AsyncBall(address, "conformance", patienceS);
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
