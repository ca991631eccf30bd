// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Globalization;
using System.Net.Sockets;
using System.Threading;
using System.Threading.Tasks;

namespace Hedgehog
{
    /// <summary>A connection to the daemon for a frame loop: nothing here waits. The effects of a connection end with it.
    /// After a lost connection the next call connects anew in the background, no more often than the back-off allows. What the
    /// program subscribed to is subscribed to again; its effects are not made again.
    /// Any thread; two threads of its own read and write. Tasks end with RequestError or NotConnected.</summary>
    public sealed class AsyncBall : AsyncMethods, IDisposable
    {
        private const int ReceiveBytes = 1 << 16;

        private readonly object gate = new object();
        private readonly List<Address> addresses;
        private readonly Params introduction;
        private readonly int timeoutMs;
        private readonly Backoff backoff = new Backoff();
        private readonly Dictionary<long, Pending> pending = new Dictionary<long, Pending>();
        private readonly Subscriptions subscriptions = new Subscriptions();
        /// What was asked for again on this connection.
        private readonly Dictionary<long, Subscriptions.Change> renewals = new Dictionary<long, Subscriptions.Change>();
        private readonly Notifications notifications = new Notifications();
        private TaskCompletionSource<Results.Hello> opening;
        private Wire wire;
        private Results.Hello welcome;
        private long lastId;
        private bool closed;
        private bool welcomed;

        /// <summary>In seconds; tests have another clock and other connections. Not while this ball connects.</summary>
        internal Func<double> Now = SecondsOf(Stopwatch.StartNew());
        internal Func<Address, int, Wire> OpenWire = Wire.Connect;

        /// <summary>After each connection but the first, on a thread of the library.</summary>
        public event Action<Results.Hello> Reconnected;

        /// <summary>The daemon of a new connection refuses a subscription; it has ended. On a thread of the library, which may call
        /// this ball.</summary>
        public event Action<SubscriptionEnded> SubscriptionEnded;

        /// <summary>Does not connect yet. address: "127.0.0.1:7586" or "/run/hedgehog/hedgehogd.sock"; null: found as by every
        /// client. name: of this game, as the daemon's log shows it. timeoutS: the longest that connecting, and waiting for a
        /// response, take. token: of roles beyond those of this machine, else HEDGEHOG_TOKEN. Throws AddressError.</summary>
        public AsyncBall(string address = null, string name = "unity", double timeoutS = 2.0, string token = null)
        {
            addresses = Address.OfDaemon(address);
            if (token == null) token = Environment.GetEnvironmentVariable("HEDGEHOG_TOKEN");
            if (token == "") token = null;
            introduction = new Params().Set("client", name).Set("protocol", "1").Set("token", token);
            timeoutMs = (int)Math.Max(1.0, Math.Min(1000.0 * timeoutS, 3600000.0));
        }

        public bool Connected
        {
            get { lock (gate) return welcome != null; }
        }

        /// <summary>What the daemon said of itself: server, role, limits. null while not connected.</summary>
        public Results.Hello Hello
        {
            get { lock (gate) return welcome; }
        }

        /// <summary>How long no other attempt to connect is made; 0: the next call makes one.</summary>
        public double RetryAfterS
        {
            get { lock (gate) return backoff.RemainingS(Now()); }
        }

        /// <summary>Connects, unless it is connected.</summary>
        public Task<Results.Hello> Open()
        {
            lock (gate)
            {
                if (closed) return Failed<Results.Hello>(new NotConnected("this ball is closed"));
                if (welcome != null) return Task.FromResult(welcome);
                if (opening != null) return opening.Task;
                double waitS = backoff.RemainingS(Now());
                if (waitS > 0.0)
                    return Failed<Results.Hello>(new NotConnected("the daemon does not run; next attempt in " +
                        waitS.ToString("0.0", CultureInfo.InvariantCulture) + " s", waitS));
                opening = new TaskCompletionSource<Results.Hello>(TaskCreationOptions.RunContinuationsAsynchronously);
                new Thread(Run) { IsBackground = true, Name = "Hedgehog reader" }.Start();
                return opening.Task;
            }
        }

        /// <summary>The result of a method.</summary>
        public override Task<Json> Call(string method, Params parameters = null)
        {
            lock (gate)
            {
                if (welcome != null) return Ask(method, parameters);
            }
            return OpenAndAsk(method, parameters);
        }

        /// <summary>Sends and wants no response. False: nothing was sent, there is no daemon; then it connects meanwhile.</summary>
        public bool Notify(string method, Params parameters = null)
        {
            lock (gate)
            {
                if (welcome != null)
                {
                    if (wire.Send(Exchange.Line(0, method, parameters)))
                    {
                        subscriptions.CarriedOut(subscriptions.Sent(method, parameters));
                        return true;
                    }
                    End("the daemon does not read from the connection");
                    return false;
                }
            }
            Ignore(Open());
            return false;
        }

        /// <summary>A vibration that goes on while this is called every frame: strength 0..1, begins where it can be felt, ends by
        /// itself 250 ms after the last frame; 0 ends it at once. As Notify. others: more parameters of effect.vibrate.</summary>
        public bool Rumble(string slot, double strength, Direction direction = null, double? frequencyHz = null, Params others = null)
        {
            if (!(strength > 0.0)) return Notify("effect.stop", new Params().Set("slot", slot));
            Results.Hello hello = Hello;
            if (hello == null)
            {
                Ignore(Open());
                return false;
            }
            var more = new Params().Set("frequency_hz", frequencyHz).Merge(others);
            return Notify("effect.vibrate", Hedgehog.Rumble.Of(slot, strength, hello.Limits, direction, more));
        }

        /// <summary>The oldest notification that nobody has fetched; does not wait.</summary>
        public bool TryNext(out Notification notification)
        {
            lock (gate)
            {
                notification = notifications.Take(null);
                return notification != null;
            }
        }

        /// <summary>The same, and waits for one. kind: of that subscription ("events") only; null: of all. False: none came in time.
        /// Throws NotConnected, and SubscriptionEnded when that kind has ended and nothing is left of it.</summary>
        internal bool Next(out Notification notification, double timeoutS, string kind = null)
        {
            double untilS = Now() + timeoutS;
            string method = kind == "events" ? "event" : kind;
            lock (gate)
            {
                for (;;)
                {
                    notification = notifications.Take(method);
                    if (notification != null) return true;
                    SubscriptionEnded ended = subscriptions.EndOf(kind);
                    if (ended != null) throw ended;
                    if (wire == null) throw new NotConnected("the connection to the daemon has ended");
                    double leftS = untilS - Now();
                    if (leftS <= 0.0) return false;
                    Monitor.Wait(gate, (int)Math.Ceiling(1000.0 * Math.Min(leftS, 60.0)));
                }
            }
        }

        /// <summary>Ends the connection, and with it its effects. What was sent before is still written.</summary>
        public void Dispose()
        {
            Wire flushed;
            lock (gate)
            {
                closed = true;
                flushed = wire;
            }
            if (flushed != null) flushed.Close(true);
            End("this ball is closed");
        }

        private async Task<Json> OpenAndAsk(string method, Params parameters)
        {
            await Open().ConfigureAwait(false);
            return await Ask(method, parameters).ConfigureAwait(false);
        }

        private Task<Json> Ask(string method, Params parameters)
        {
            return Ask(method, parameters, timeoutMs);
        }

        private Task<Json> Ask(string method, Params parameters, int withinMs)
        {
            lock (gate)
            {
                if (wire == null) return Failed<Json>(new NotConnected("the connection to the daemon has ended"));
                long id = ++lastId;
                byte[] line = Exchange.Line(id, method, parameters);
                Wire of = wire;
                string late = method + ": no response within " + (0.001 * timeoutMs).ToString(CultureInfo.InvariantCulture) + " s";
                var asked = new Pending(subscriptions.Sent(method, parameters), withinMs, () => EndOf(of, late));
                pending.Add(id, asked);
                if (!wire.Send(line)) End("the daemon does not read from the connection");
                return asked.Response;
            }
        }

        /// The thread that connects and then reads until the connection ends.
        private void Run()
        {
            // One for all addresses and the introduction.
            var deadline = new Deadline(Now, timeoutMs);
            Wire opened = Connect(deadline);
            if (opened == null) return;
            lock (gate)
            {
                wire = opened;
                if (closed) End("this ball is closed");
                else Introduce(opened, deadline.ShareMs());
            }
            var notice = new Notice();
            string why = Read(opened, notice);
            EndOf(opened, why, notice.RetryAfterS);
        }

        private void Introduce(Wire to, int withinMs)
        {
            Ask("hello", introduction, withinMs).ContinueWith(answered =>
            {
                Results.Hello again;
                lock (gate)
                {
                    // Unless another connection has followed.
                    if (wire != to || opening == null) return;
                    if (answered.IsFaulted)
                    {
                        Exception why = answered.Exception.InnerException;
                        TaskCompletionSource<Results.Hello> waiting = opening;
                        opening = null;
                        End(why.Message);
                        waiting.TrySetException(why);
                        return;
                    }
                    welcome = new Results.Hello(answered.Result);
                    backoff.Succeeded();
                    foreach (var one in subscriptions.Current())
                    {
                        renewals.Add(++lastId, one);
                        wire.Send(Exchange.Line(lastId, one.Method, one.Parameters));
                    }
                    again = welcomed ? welcome : null;
                    welcomed = true;
                    opening.TrySetResult(welcome);
                    opening = null;
                }
                Action<Results.Hello> told = Reconnected;
                if (again != null && told != null) told(again);
            }, CancellationToken.None, TaskContinuationOptions.None, TaskScheduler.Default);
        }

        /// null: nobody is there, and everybody has been told.
        private Wire Connect(Deadline deadline)
        {
            var why = new List<string>();
            foreach (var address in addresses)
            {
                try
                {
                    return OpenWire(address, deadline.ShareMs(addresses.Count - why.Count));
                }
                catch (SocketException error)
                {
                    why.Add(address + ": " + Words(error));
                }
                catch (Exception error)
                {
                    // Whatever it is: nobody else catches it on this thread, and it would end the game.
                    why.Add(address + ": " + error.Message);
                }
            }
            lock (gate) End("the daemon does not run: " + string.Join("; ", why), "");
            return null;
        }

        /// Why it ended.
        private string Read(Wire from, Notice notice)
        {
            var exchange = new Exchange();
            var bytes = new byte[ReceiveBytes];
            try
            {
                for (;;)
                {
                    int count = from.Receive(bytes);
                    if (count <= 0) return notice.Or("the daemon closed it");
                    foreach (var message in exchange.Receive(bytes, count))
                    {
                        notice.Take(message);
                        Take(message);
                    }
                }
            }
            catch (SocketException error)
            {
                return notice.Or(Words(error));
            }
            catch (FormatException error)
            {
                return "the server is not a Hedgehog daemon: " + error.Message;
            }
        }

        private void Take(Json message)
        {
            SubscriptionEnded ended;
            lock (gate)
            {
                string method = message["method"].Text;
                if (method != null)
                {
                    notifications.Add(new Notification(method, message["params"]));
                    Monitor.PulseAll(gate);
                    return;
                }
                long id = message["id"].Integer;
                Pending asked;
                if (pending.TryGetValue(id, out asked))
                {
                    pending.Remove(id);
                    if (message["error"].IsNull) subscriptions.CarriedOut(asked.Change);
                    asked.Answer(message);
                    return;
                }
                ended = TakeRenewal(id, message["error"]);
                if (ended != null) Monitor.PulseAll(gate);
            }
            Action<SubscriptionEnded> told = SubscriptionEnded;
            // By another thread: this one reads the responses to what a handler asks for. What a handler throws is an unobserved exception.
            if (ended != null && told != null) Task.Run(() => told(ended));
        }

        /// null: nothing has ended by this response.
        private SubscriptionEnded TakeRenewal(long id, Json error)
        {
            Subscriptions.Change renewal;
            if (!renewals.TryGetValue(id, out renewal)) return null;
            renewals.Remove(id);
            return error.IsNull ? null : subscriptions.Refused(renewal, error);
        }

        /// Unless another connection has followed.
        private void EndOf(Wire of, string why, double retryAfterS = 0.0)
        {
            lock (gate)
            {
                if (wire == of) End(why, retryAfterS: retryAfterS);
            }
        }

        /// Everybody who waits is told.
        private void End(string why, string before = "the connection to the daemon has ended: ", double retryAfterS = 0.0)
        {
            lock (gate)
            {
                if (wire != null) wire.Close(false);
                wire = null;
                welcome = null;
                double nowS = Now();
                backoff.Failed(nowS, retryAfterS);
                var lost = new NotConnected(before + why, backoff.RemainingS(nowS));
                foreach (var asked in pending.Values) asked.Fail(lost);
                pending.Clear();
                renewals.Clear();
                if (opening != null) opening.TrySetException(lost);
                opening = null;
                Monitor.PulseAll(gate);
            }
        }

        private static Func<double> SecondsOf(Stopwatch clock)
        {
            return () => clock.Elapsed.TotalSeconds;
        }

        private static string Words(SocketException error)
        {
            switch (error.SocketErrorCode)
            {
                case SocketError.ConnectionRefused: return "Connection refused";
                case SocketError.HostNotFound: return "no such host";
                case SocketError.TimedOut:
                case SocketError.WouldBlock: return "no answer";
                default: return error.Message;
            }
        }

        private static Task<T> Failed<T>(Exception why)
        {
            var failed = new TaskCompletionSource<T>();
            failed.SetException(why);
            return failed.Task;
        }

        /// A failure that nobody waits for is no unobserved one.
        private static void Ignore(Task task)
        {
            task.ContinueWith(failed => GC.KeepAlive(failed.Exception), CancellationToken.None,
                TaskContinuationOptions.OnlyOnFaulted | TaskContinuationOptions.ExecuteSynchronously, TaskScheduler.Default);
        }
    }
}
