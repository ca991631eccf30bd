// SPDX-License-Identifier: MIT
using System;
using System.Threading.Tasks;
using UnityEngine;

namespace Hedgehog.Unity
{
    /// <summary>The ball in a scene. Connects while it is enabled and again whenever the daemon is back; nothing waits for the
    /// daemon. Of the main thread.</summary>
    [AddComponentMenu("Hedgehog/Hedgehog Ball")]
    [DisallowMultipleComponent]
    public sealed class HedgehogBall : MonoBehaviour
    {
        [SerializeField]
        [Tooltip("127.0.0.1:7586 or a socket's path. Empty: HEDGEHOG_ADDRESS, else as every client finds the daemon.")]
        private string address = "";

        [SerializeField]
        [Range((float)Ranges.GainMin, (float)Ranges.GainMax)]
        [Tooltip("Multiplies the strength of everything that this component plays.")]
        private float gain = 1f;

        private AsyncBall client;
        private Task opening;
        /// The connection on which this has subscribed, and the one that was reported; null: none.
        private volatile Results.Hello prepared;
        private Results.Hello reported;
        /// Why there is no connection, and the refusals of this component's subscriptions on it; empty: none.
        private string connectionProblem = "";
        private string eventsProblem = "";
        private string telemetryProblem = "";
        /// Of SubscribeTelemetry.
        private int telemetryRequests;
        private float telemetryHz;
        private string[] telemetryFields;

        /// <summary>The daemon is back after a lost connection, on the main thread: events and telemetry come again, effects have
        /// ended and are the game's to start again.</summary>
        public event Action Reconnected;

        /// <summary>What happened to effects and to the ball, on the main thread.</summary>
        public event Action<Results.Event> EventReceived;

        /// <summary>The status, after SubscribeTelemetry, on the main thread.</summary>
        public event Action<Results.Telemetry> TelemetryReceived;

        /// <summary>All methods of the protocol. null while disabled.</summary>
        public AsyncBall Client
        {
            get { return client; }
        }

        public bool Connected
        {
            get { return client != null && client.Connected; }
        }

        /// <summary>Why nothing is felt, or why events or telemetry do not come, one sentence; empty: all is well.</summary>
        public string Problem
        {
            get { return connectionProblem != "" ? connectionProblem : eventsProblem != "" ? eventsProblem : telemetryProblem; }
        }

        /// <summary>A vibration that goes on while this is called every frame: strength 0..1, 0 ends it. direction as Unity has it:
        /// x right, y up, z forward; zero: none. False: there is no daemon.</summary>
        public bool Rumble(string slot, float strength, Vector3 direction, float frequencyHz = 70f)
        {
            if (client == null) return false;
            return client.Rumble(slot, gain * strength, ToBall(direction), frequencyHz);
        }

        /// <summary>One push. The task may be awaited for what the ball makes of it, or not; it ends with RequestError or
        /// NotConnected.</summary>
        public Task<Results.Admission> Pulse(Vector3 direction, float strength = 1f, float durationMs = 180f, int priority = 5)
        {
            Results.Hello hello = client == null ? null : client.Hello;
            if (hello == null)
                return Observed(Task.FromException<Results.Admission>(new NotConnected(Problem != "" ? Problem : "the ball is not connected")));
            double level = Hedgehog.Rumble.FeltLevel(gain * strength, hello.Limits.FeltA, hello.Limits.CurrentA);
            return Observed(client.Pulse(ToBall(direction), level: level, durationMs: durationMs, priority: priority));
        }

        /// <summary>Ends all effects of this game: for a pause menu.</summary>
        public bool StopAll()
        {
            return client != null && client.Notify("effect.stop_all");
        }

        /// <summary>From now on TelemetryReceived comes so many times a second, after a lost connection too; 0 ends it. fields: keys
        /// of the status; none: all but pins. There is one telemetry a component; the last call holds. Problem has the daemon's refusal.
        /// </summary>
        public void SubscribeTelemetry(float rateHz, params string[] fields)
        {
            telemetryHz = rateHz;
            telemetryFields = fields.Length == 0 ? null : fields;
            if (Connected) Observed(AskForTelemetry(client));
        }

        /// <summary>A Unity vector in the ball's frame; null for zero.</summary>
        public static Direction ToBall(Vector3 v)
        {
            return v.x == 0f && v.y == 0f && v.z == 0f ? null : Direction.Vector(v.z, -v.x, v.y);
        }

        private void OnEnable()
        {
            connectionProblem = "the daemon has not been reached yet";
            try
            {
                client = new AsyncBall(address, Application.productName);
            }
            catch (AddressError error)
            {
                connectionProblem = error.Message;
                Debug.LogWarning(Problem, this);
            }
        }

        private void Update()
        {
            if (client == null) return;
            Results.Hello hello = client.Hello;
            if (hello == null && connectionProblem == "") connectionProblem = "the connection to the daemon has ended";
            // A rumble may have connected it meanwhile, which subscribes to nothing new.
            bool due = hello == null || hello != prepared;
            if (due && client.RetryAfterS <= 0.0 && (opening == null || opening.IsCompleted)) opening = Open(client);
            Report();
            Notification received;
            while (client != null && client.TryNext(out received))
            {
                Results.Event happened = received.Event;
                Results.Telemetry status = received.Telemetry;
                if (happened != null && EventReceived != null) EventReceived(happened);
                if (status != null && TelemetryReceived != null) TelemetryReceived(status);
            }
        }

        private void Report()
        {
            Results.Hello now = prepared;
            if (now == reported) return;
            bool again = reported != null;
            reported = now;
            if (again && Reconnected != null) Reconnected();
        }

        private void OnDisable()
        {
            AsyncBall ended = client;
            client = null;
            prepared = reported = null;
            connectionProblem = eventsProblem = telemetryProblem = "";
            if (ended != null) ended.Dispose();
        }

        private async Task Open(AsyncBall of)
        {
            try
            {
                await of.Open();
                Results.Hello hello = of.Hello;
                string refusal = await RefusalOf(of.EventsSubscribe());
                await AskForTelemetry(of);
                if (of != client) return;
                eventsProblem = refusal;
                connectionProblem = "";
                // Also after a refusal: the same request would be refused again.
                prepared = hello;
            }
            catch (BallError error)
            {
                if (of == client) connectionProblem = error.Message;
            }
        }

        private async Task<bool> AskForTelemetry(AsyncBall of)
        {
            int number = ++telemetryRequests;
            string refusal = telemetryHz > 0f ? await RefusalOf(of.TelemetrySubscribe(telemetryHz, telemetryFields))
                                              : await RefusalOf(of.TelemetryUnsubscribe());
            // Unless the game has asked for another meanwhile.
            if (of == client && number == telemetryRequests) telemetryProblem = refusal;
            return refusal == "";
        }

        /// Empty: the daemon has accepted it. Throws NotConnected.
        private static async Task<string> RefusalOf<T>(Task<T> request)
        {
            try
            {
                await request;
                return "";
            }
            catch (RequestError error)
            {
                return error.Message;
            }
        }

        /// A refusal that nobody awaits is no unobserved exception.
        private static Task<T> Observed<T>(Task<T> task)
        {
            task.ContinueWith(failed => GC.KeepAlive(failed.Exception), TaskContinuationOptions.OnlyOnFaulted);
            return task;
        }
    }
}
