// SPDX-License-Identifier: MIT
// How the core connects, mostly on a clock of the test: how long it takes, and what fails.
using System;
using System.IO;
using System.Net;
using System.Net.Sockets;
using System.Threading.Tasks;
using Hedgehog;

internal static class ConnectTest
{
    private const int TimeoutMs = 600000;
    /// Far more than a busy machine needs.
    private const int LimitMs = 60000;

    private static double nowS;

    public static bool Run()
    {
        bool well = Check.Run("connecting to several addresses takes its timeout altogether", SilentAddresses);
        well &= Check.Run("the addresses of a name share its time", SilentName);
        well &= Check.Run("the introduction has what is left of the time", SilentDaemon);
        well &= Check.Run("whatever is thrown while connecting is a reason, and the next address is tried", Thrown);
        well &= Check.Run("a name server that does not answer has a timeout", SlowName);
        return well;
    }

    private static SocketException Silence(int ms)
    {
        nowS += 0.001 * ms;
        return new SocketException((int)SocketError.TimedOut);
    }

    /// A ball that searches in three places; `open`: opens each.
    private static AsyncBall Searching(Func<Address, int, Wire> open)
    {
        Environment.SetEnvironmentVariable("RUNTIME_DIRECTORY", "/a");
        Environment.SetEnvironmentVariable("HEDGEHOG_ADDRESS", null);
        nowS = 1000.0;
        return new AsyncBall(timeoutS: 0.001 * TimeoutMs) { Now = () => nowS, OpenWire = open };
    }

    private static NotConnected FailureOf(AsyncBall ball)
    {
        Task<Hedgehog.Results.Hello> opened = ball.Open();
        Check.That(((IAsyncResult)opened).AsyncWaitHandle.WaitOne(LimitMs), "the attempt ends");
        return Check.Throws<NotConnected>(() => opened.GetAwaiter().GetResult());
    }

    private static void SilentAddresses()
    {
        int tried = 0;
        using (AsyncBall ball = Searching((address, ms) => { ++tried; throw Silence(ms); }))
            FailureOf(ball);
        Check.That(tried >= 3, tried + " addresses");
        Check.That(Math.Abs(nowS - 1000.0 - 0.001 * TimeoutMs) < 0.01, (nowS - 1000.0) + " s");
    }

    private static void SilentName()
    {
        nowS = 1000.0;
        var found = new[] { IPAddress.Loopback, IPAddress.Loopback, IPAddress.Loopback };
        var deadline = new Deadline(() => nowS, TimeoutMs);
        Check.Throws<SocketException>(() => Wire.First(found, deadline, (one, ms) => { throw Silence(ms); }));
        Check.That(Math.Abs(nowS - 1000.0 - 0.001 * TimeoutMs) < 0.01, (nowS - 1000.0) + " s");
    }

    private static void SilentDaemon()
    {
        var listener = new TcpListener(IPAddress.Loopback, 0);
        listener.Start();
        Address place = Address.Parse(listener.LocalEndpoint.ToString());
        Func<Address, int, Wire> late = (address, ms) =>
        {
            // 50 ms before the end.
            nowS += 0.001 * (TimeoutMs - 50);
            return Wire.Connect(place, LimitMs);
        };
        using (AsyncBall ball = Searching(late))
            Check.That(FailureOf(ball).Message.Contains("hello: no response within 600 s"), "the reason");
        listener.Stop();
    }

    private static void Thrown()
    {
        using (AsyncBall ball = Searching((address, ms) => { throw new NotSupportedException("not on this system"); }))
        {
            string why = FailureOf(ball).Message;
            Check.That(why.StartsWith("the daemon does not run: /a/hedgehogd.sock: not on this system; "), why);
            Check.That(why.EndsWith("127.0.0.1:7586: not on this system"), why);
        }
    }

    /// The name server of slow_names.cpp.
    private static void SlowName()
    {
        string known = Environment.GetEnvironmentVariable("HEDGEHOG_NAMES_KNOWN");
        Task<Exception> failed = Task.Run(() => (Exception)Check.Throws<SocketException>(() => Wire.Connect(Address.Parse("slow.test"), 50)));
        try
        {
            Check.That(((IAsyncResult)failed).AsyncWaitHandle.WaitOne(LimitMs), "the attempt ends");
            Check.Equal(SocketError.TimedOut, ((SocketException)failed.Result).SocketErrorCode, "the reason");
        }
        finally
        {
            // Else the thread that waits would outlive the test.
            File.WriteAllText(known, "");
        }
    }
}
