// SPDX-License-Identifier: MIT
// conformance.json against the C# library, blocking and as tasks: conformance.exe FOLDER. Exit: 0 all cases pass.
using System;
using System.Diagnostics;
using System.IO;
using System.Threading;
using Hedgehog;

internal static partial class Conformance
{
    // Of calls, unless the case has one of its own.
    private const double TimeoutS = 60.0;

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
        well &= Check.Run("C# Ball: an enumeration throws once its subscription has ended", EndedEnumeration);
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
        string address;
        using (Process daemon = Start(name, out address))
        {
            Json steps = one["client"];
            Json environment = one["environment"];
            for (int i = 0; i < environment.Count; ++i) Environment.SetEnvironmentVariable(environment.NameAt(i), environment[i].Text);
            double timeoutS = one.Has("timeout_s") ? one["timeout_s"].Number : TimeoutS;
            Library library = blocking ? (Library)new BlockingLibrary() : new TaskLibrary();
            if (steps[0].Has("open"))
            {
                Outcome(steps[0], () => library.Open(address, timeoutS));
            }
            else
            {
                library.Open(address, timeoutS);
                for (int i = 0; i < steps.Count; ++i)
                {
                    Stopwatch taken = Stopwatch.StartNew();
                    Step(library, steps[i]);
                    Check.That(taken.Elapsed.TotalSeconds >= (steps[i].Has("at_least_s") ? steps[i]["at_least_s"].Number : 0.0), taken.Elapsed + " taken");
                }
                library.Close();
            }
            for (int i = 0; i < environment.Count; ++i) Environment.SetEnvironmentVariable(environment.NameAt(i), null);
            Finish(daemon);
        }
    }

    private static Process Start(string name, out string address)
    {
        var daemon = Process.Start(new ProcessStartInfo("python3", "\"" + Path.Combine(folder, "fake_daemon.py") + "\" \"" + name + "\"")
        {
            UseShellExecute = false, RedirectStandardOutput = true, RedirectStandardError = true
        });
        address = "127.0.0.1:" + daemon.StandardOutput.ReadLine().Trim();
        return daemon;
    }

    private static void Finish(Process daemon)
    {
        string errors = daemon.StandardError.ReadToEnd();
        daemon.WaitForExit();
        Check.Equal("", errors, "the daemon's errors");
        Check.Equal(0, daemon.ExitCode, "the daemon's exit");
    }

    private static void Step(Library library, Json step)
    {
        if (step.Has("not_finite"))
        {
            Check.Throws<ArgumentException>(() => library.Call(step["call"].Text, ParamsOf(step["params"]).Set(step["not_finite"].Text, double.NaN)));
        }
        else if (step.Has("call"))
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
            Json result = Outcome(step, library.Answer);
            if (step.Has("result")) Check.Equal(step["result"].ToString(), result.ToString(), "the response");
        }
        else if (step.Has("ask_when_ended"))
        {
            library.AskedWhenEnded = step["ask_when_ended"].Text;
        }
        else if (step.Has("flood"))
        {
            Flood(library, step["flood"].Text);
        }
        else if (step.Has("rumble_again"))
        {
            while (!library.Rumble(step["rumble_again"].Text, step["strength"].Number, null, null)) Thread.Sleep(10);
        }
        else if (step.Has("next_of"))
        {
            Check.Equal(step["params"].ToString(), library.NextOf(step["next_of"].Text).ToString(), "the next of " + step["next_of"].Text);
        }
        else if (step.Has("subscriptions_ended"))
        {
            // They are reported by another thread.
            string expected = step["subscriptions_ended"].ToString();
            Stopwatch waited = Stopwatch.StartNew();
            while (library.Ended.Length < expected.Length && waited.Elapsed.TotalSeconds < TimeoutS) Thread.Sleep(1);
            Check.Equal(expected, library.Ended, "subscriptions that have ended");
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
            if (step.Has("retry_s"))
                Check.That(lost.RetryAfterS >= step["retry_s"][0].Number && lost.RetryAfterS <= step["retry_s"][1].Number, lost.RetryAfterS + " s");
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

    private static void Flood(Library library, string method)
    {
        // A line is shorter than 64 KiB; all together are far more than what the kernel and the library keep.
        var given = new Params().Set("text", new string('x', 30000));
        for (int line = 0; line < 8000; ++line)
            if (!library.Notify(method, given)) return;
        Check.That(false, "what the daemon does not read is kept");
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
}
