// SPDX-License-Identifier: MIT
// The C# library and the sample, and what live_component.cs has, against a simulated daemon: live.exe ADDRESS. Exit: 0 all is well.
using System;
using System.Threading;
using Hedgehog;
using Hedgehog.Samples;
using Hedgehog.Unity;
using UnityEngine;
using Results = Hedgehog.Results;

internal static partial class Live
{
    private const double TimeoutS = 60.0;

    private static string address;

    private static int Main(string[] arguments)
    {
        address = arguments[0];
        bool well = Check.Run("a pulse is played and ends", Pulse);
        well &= Check.Run("a rumble continues in its slot and ends", RumbleInSlot);
        well &= Check.Run("a response is typed, and a refusal has its reason", Typed);
        well &= Check.Run("telemetry has the requested fields", Telemetry);
        well &= Check.Run("a thread that waits for events blocks no call of another", TwoThreads);
        well &= Check.Run("what was sent before the end is still played", SentBeforeTheEnd);
        well &= Check.Run("a missing daemon is reported in a sentence", WithoutDaemon);
        well &= Check.Run("the component connects, plays and ends", Component);
        well &= Check.Run("the component without a daemon reports why", ComponentAlone);
        well &= Check.Run("the component with a wrong address reports it", ComponentWithoutAddress);
        well &= Check.Run("the component reconnects, subscribes again and reports it on the main thread", ComponentAgain);
        well &= Check.Run("the component reports a refused subscription and asks for it once", ComponentRefused);
        well &= Check.Run("a rumble that connects first keeps no event from the component", RumbleConnects);
        well &= Check.Run("the racer's impacts are eight separate steps", RacerSteps);
        well &= Check.Run("the racer's car is felt", RacerFelt);
        return well ? 0 : 1;
    }

    private static Results.Event First(System.Collections.Generic.IEnumerable<Results.Event> events)
    {
        foreach (var one in events) return one;
        throw new Exception("no event came");
    }

    private static void Pulse()
    {
        using (var ball = new Ball(address, timeoutS: TimeoutS))
        {
            var events = ball.Events(new[] { "effect_ended" }, timeoutS: TimeoutS);
            long effect = ball.Pulse("left", level: 0.5, durationMs: 30).Effect;
            Results.Event ended = First(events);
            Check.Equal((long?)effect, ended.Effect, "the effect");
            Check.Equal("completed", ended.Reason, "why it ended");
        }
    }

    private static void RumbleInSlot()
    {
        using (var ball = new Ball(address, timeoutS: TimeoutS))
        {
            var events = ball.Events(new[] { "effect_started" }, timeoutS: TimeoutS);
            var longer = new Params().Set("lease_ms", 10000.0);
            Check.That(ball.Rumble("engine", 0.3, Direction.Back, 70, longer), "sent");
            Check.Equal("engine", First(events).Slot, "the slot");
            Check.That(ball.Rumble("engine", 0.4, Direction.Back, 70, longer), "sent");
            Check.Equal(1, ball.Status().Effects.Length, "effects");
            ball.Rumble("engine", 0);
            Check.Equal(0L, ball.StopAll().StoppedValue, "still playing");
        }
    }

    private static void Typed()
    {
        using (var ball = new Ball(address, timeoutS: TimeoutS))
        {
            Check.Equal("armed", ball.Status().State, "the state");
            Check.That(ball.Status().TemperatureC.Model > 10.0, "the temperature");
            Check.That(ball.Describe().Pins.Length > 80, "pins");
            Check.Equal(3, ball.Describe().Coils.Matrix.Count, "rows");
            var keyframes = new[] { new Params().Set("t_ms", 0.0).Set("level", 0.2), new Params().Set("t_ms", 50.0).Set("level", 0.0) };
            Check.That(ball.Play(keyframes: keyframes, waveform: Waveform.Sine).Accepted, "key frames are played");
            var refused = Check.Throws<RequestError>(() => ball.Pulse(Direction.Vector(0, 1, 0), level: Ranges.LevelMax + 0.4));
            Check.Equal(ErrorCode.InvalidParams, refused.Code, "the code");
            Check.Equal(ErrorName.InvalidParams, refused.Name, "the name");
            Check.Equal("level", refused.Data.Field, "the field");
            Check.Equal(1.4, refused.Data.Value.Number, "the value");
        }
    }

    private static void Telemetry()
    {
        using (var ball = new Ball(address, timeoutS: TimeoutS))
        {
            int count = 0;
            foreach (var status in ball.Telemetry(100, new[] { "limit_a" }, TimeoutS))
            {
                Check.That(status.LimitA > 0.0 && status.State == null, "limit_a alone");
                if (++count == 3) break;
            }
        }
    }

    private static void TwoThreads()
    {
        using (var ball = new Ball(address, timeoutS: TimeoutS))
        {
            var events = ball.Events(new[] { "effect_ended" });
            long? ended = null;
            var waiting = new Thread(() => ended = First(events).Effect);
            waiting.Start();
            long effect = ball.Pulse("left", durationMs: 30).Effect;
            waiting.Join();
            Check.Equal((long?)effect, ended, "the effect");
        }
    }

    private static void SentBeforeTheEnd()
    {
        using (var other = new Ball(address, timeoutS: TimeoutS))
        {
            var events = other.Events(new[] { "effect_ended" }, Scope.All, TimeoutS);
            using (var ball = new Ball(address, timeoutS: TimeoutS))
                for (int i = 0; i < 20; ++i)
                    ball.Notify("effect.pulse", new Params().Set("direction", "left").Set("duration_ms", 40.0).Set("on_close", "finish"));
            for (int i = 0; i < 20; ++i) Check.Equal("completed", First(events).Reason, "why it ended");
        }
    }

    private static void WithoutDaemon()
    {
        var missing = Check.Throws<NotConnected>(() => new Ball("127.0.0.1:1"));
        Check.Equal("the daemon does not run: 127.0.0.1:1: Connection refused", missing.Message, "the sentence");
        Check.That(missing.RetryAfterS > 0.0, "when to try again");
        var none = Check.Throws<NotConnected>(() => new Ball("/none/hedgehogd.sock"));
        Check.That(none.Message.StartsWith("the daemon does not run: /none/hedgehogd.sock: "), none.Message);
        Check.Throws<AddressError>(() => new AsyncBall("host:0"));
    }

    private static void RacerSteps()
    {
        Check.Equal(0, RacerHaptics.StepOf(1), "the softest");
        Check.Equal(7, RacerHaptics.StepOf(20000), "the hardest");
        Check.Equal(2.1, RacerHaptics.StrengthOf(0, 2.1, 15.0), "just felt");
        Check.That(Math.Abs(RacerHaptics.StrengthOf(7, 2.1, 15.0) - 15.0) < 1e-9, "full");
        for (int step = 0; step < 7; ++step)
            Check.That(RacerHaptics.StrengthOf(step + 1, 2.1, 6.0) / RacerHaptics.StrengthOf(step, 2.1, 6.0) > 1.13, "told apart");
    }

    private static void RacerFelt()
    {
        HedgehogBall ball = Enabled();
        var car = new RacerCar();
        car.Set("ball", ball);
        car.Message("OnEnable");
        int started = 0;
        string skid = null;
        Results.Telemetry status = null;
        ball.TelemetryReceived += now => status = now;
        ball.EventReceived += happened =>
        {
            if (happened.Type != "effect_started") return;
            if (happened.Slot == null) ++started;
            else skid = happened.Slot;
        };
        car.Message("OnCollisionEnter", new Collision { impulse = new Vector3(3000, 0, 0), contact = { point = Vector3.left } });
        // Too soon after a harder one.
        car.Message("OnCollisionEnter", new Collision { impulse = new Vector3(300, 0, 0), contact = { point = Vector3.left } });
        Time.time = 1f;
        car.Land(8000);
        Frames(ball, () =>
        {
            car.Skid(0.5f);
            return started >= 2 && skid == "skid" && status != null;
        });
        Check.That(status.Derating.HasValue && status.State == null, "what the gain needs, and no more");
        car.Tumble();
        Check.Equal(2, started, "blows");
        car.Message("OnDisable");
        ball.Message("OnDisable");
    }
}
