// SPDX-License-Identifier: MIT
// The component and its inspector against a simulated daemon, in frames of a stub of the engine.
using System;
using System.Threading;
using Hedgehog;
using Hedgehog.Editor;
using Hedgehog.Unity;
using UnityEditor;
using UnityEngine;
using Results = Hedgehog.Results;

internal static partial class Live
{
    /// Frames until it is so; a test that never gets there is ended by whoever runs it.
    private static void Frames(MonoBehaviour one, Func<bool> until)
    {
        do
        {
            one.Message("Update");
            Thread.Sleep(1);
        } while (!until());
    }

    private static HedgehogBall Enabled(string at = null)
    {
        var ball = new HedgehogBall();
        ball.Set("address", at ?? address);
        ball.Message("OnEnable");
        Frames(ball, () => ball.Problem == "");
        return ball;
    }

    private static void Component()
    {
        HedgehogBall ball = Enabled();
        string slot = null;
        ball.EventReceived += happened => slot = slot ?? happened.Slot;
        Frames(ball, () =>
        {
            Check.That(ball.Rumble("wheel", 0.5f, Vector3.up), "sent");
            return slot != null;
        });
        Check.Equal("wheel", slot, "the slot");
        var pulse = ball.Pulse(Vector3.left, 0.5f);
        Frames(ball, () => pulse.IsCompleted);
        Check.That(pulse.Result.Accepted, "accepted");
        Check.That(ball.StopAll(), "stopped");

        var inspector = new HedgehogBallEditor { target = ball };
        GUILayout.pressed = "Push left";
        Check.That(inspector.RequiresConstantRepaint(), "drawn while playing");
        inspector.OnInspectorGUI();
        Check.That(EditorGUILayout.shown.StartsWith("Connected to "), EditorGUILayout.shown);
        ball.Message("OnDisable");
        Check.That(!ball.Connected && !ball.Rumble("wheel", 1f, Vector3.up), "disabled");
        inspector.OnInspectorGUI();
        Check.That(EditorGUILayout.shown.StartsWith("Play mode connects"), EditorGUILayout.shown);
    }

    private static void ComponentAlone()
    {
        var ball = new HedgehogBall();
        ball.Set("address", "127.0.0.1:1");
        ball.Message("OnEnable");
        Frames(ball, () => ball.Problem.StartsWith("the daemon does not run: 127.0.0.1:1: "));
        var pulse = ball.Pulse(Vector3.left);
        Check.That(pulse.Exception.InnerException is NotConnected, "no push");
        ball.Message("OnDisable");
    }

    private static void ComponentAgain()
    {
        using (var relay = new Relay(address))
        {
            HedgehogBall ball = Enabled(relay.Address);
            int main = Thread.CurrentThread.ManagedThreadId, again = 0, thread = main;
            Results.Telemetry status = null;
            string slot = null;
            ball.Reconnected += () =>
            {
                ++again;
                thread = Thread.CurrentThread.ManagedThreadId;
            };
            ball.TelemetryReceived += now => status = now;
            ball.EventReceived += happened => slot = happened.Slot ?? slot;
            ball.SubscribeTelemetry(50f, "limit_a");
            Frames(ball, () => status != null);

            relay.Refuse();
            Frames(ball, () => ball.Problem.StartsWith("the connection to the daemon has ended"));
            Check.That(!ball.Rumble("wheel", 0.5f, Vector3.up), "nobody plays it");
            while (ball.Client.TryNext(out _)) { }
            status = null;
            Check.Equal(0, again, "reports before it is back");

            relay.Accept();
            Frames(ball, () => again > 0 && status != null && ball.Problem == "");
            Frames(ball, () => ball.Rumble("wheel", 0.5f, Vector3.up) && slot == "wheel");
            Check.Equal(1, again, "reports");
            Check.Equal(main, thread, "the thread of the report");
            Check.That(status.LimitA > 0.0 && status.State == null, "the telemetry that was asked for");
            ball.Message("OnDisable");
            ball.Message("OnEnable");
            Frames(ball, () => ball.Problem == "");
            Check.Equal(1, again, "reports of a component that was enabled anew");
            ball.Message("OnDisable");
        }
    }

    /// A misspelt field, before the connection and on it.
    private static void ComponentRefused()
    {
        using (var relay = new Relay(address))
        {
            var ball = new HedgehogBall();
            ball.Set("address", relay.Address);
            int again = 0;
            string happened = null;
            ball.Reconnected += () => ++again;
            ball.EventReceived += one => happened = one.Slot ?? happened;
            ball.SubscribeTelemetry(10f, "temprature_c");
            ball.Message("OnEnable");
            Frames(ball, () => ball.Problem.Contains("temprature_c"));
            int lines = relay.Lines;
            for (int frame = 0; frame < 200; ++frame) Frames(ball, () => true);
            Check.That(ball.Problem.Contains("temprature_c"), ball.Problem);
            Check.Equal(lines, relay.Lines, "lines that were sent");
            Frames(ball, () => ball.Rumble("wheel", 0.5f, Vector3.up) && happened == "wheel");

            relay.Refuse();
            Frames(ball, () => ball.Problem.StartsWith("the connection to the daemon has ended"));
            relay.Accept();
            Frames(ball, () => again > 0 && ball.Problem.Contains("temprature_c"));
            Check.Equal(1, again, "reports of a new connection");

            Results.Telemetry status = null;
            ball.TelemetryReceived += now => status = now;
            ball.SubscribeTelemetry(50f, "limit_a");
            Frames(ball, () => status != null && ball.Problem == "");
            ball.SubscribeTelemetry(10f, "temprature_c");
            Frames(ball, () => ball.Problem.Contains("temprature_c"));
            ball.SubscribeTelemetry(0f);
            Frames(ball, () => ball.Problem == "");
            ball.Message("OnDisable");
        }
    }

    private static void RumbleConnects()
    {
        var ball = new HedgehogBall();
        ball.Set("address", address);
        ball.Message("OnEnable");
        while (!ball.Rumble("wheel", 0.5f, Vector3.up)) Thread.Sleep(1);
        string slot = null;
        ball.EventReceived += happened => slot = happened.Slot ?? slot;
        Frames(ball, () => ball.Problem == "");
        Frames(ball, () => ball.Rumble("other", 0.5f, Vector3.up) && slot == "other");
        ball.Message("OnDisable");
    }

    private static void ComponentWithoutAddress()
    {
        var ball = new HedgehogBall();
        ball.Set("address", "host:0");
        ball.Message("OnEnable");
        ball.Message("Update");
        Check.That(ball.Problem.StartsWith("'host:0' is no address of a daemon"), ball.Problem);
        Check.Equal(ball.Problem, Debug.warned, "the warning");
        Check.That(!ball.Rumble("wheel", 1f, Vector3.up), "nothing to play on");
        ball.Message("OnDisable");
    }
}
