// SPDX-License-Identifier: MIT
// The core without a daemon: JSON, addresses, levels. Exit: 0 all is well.
using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Net;
using System.Net.Sockets;
using System.Text;
using System.Threading;
using Hedgehog;

internal static class CoreTest
{
    private static readonly string[] NoJson =
    {
        "", " ", "{", "}", "[", "[1,]", "{\"a\"}", "{\"a\":}", "{\"a\":1,}", "{a:1}", "01", "-", "1.", ".5", "1e", "+1", "1e999", "NaN",
        "Infinity", "nul", "truee", "'a'", "\"", "\"\\x\"", "\"\\u12g4\"", "\"\u0001\"", "[1] 2", "0x10", "1,2", "[1 2]", "{\"a\" 1}", "\\"
    };

    private static int Main()
    {
        bool well = Check.Run("invalid JSON is refused", Refused);
        well &= Check.Run("values are read as they are", Values);
        well &= Check.Run("deep nesting is refused", Deep);
        well &= Check.Run("what is written is read again", RoundTrips);
        well &= Check.Run("damaged text is a FormatException or JSON", Damaged);
        well &= Check.Run("bytes in pieces of any size are the same messages", Pieces);
        well &= Check.Run("addresses are those of every client", Addresses);
        well &= Check.Run("an invalid address is refused", NoAddresses);
        well &= Check.Run("a socket that nobody accepts has a timeout", SilentSocket);
        well &= Check.Run("the token of the environment is that of the introduction", Token);
        well &= Check.Run("the next of a kind waits no longer for the messages of another", OtherKind);
        well &= Check.Run("a rumble starts at the threshold of perception", Levels);
        well &= ConnectTest.Run();
        return well ? 0 : 1;
    }

    private static void Refused()
    {
        foreach (string text in NoJson) Check.Throws<FormatException>(() => Json.Parse(text));
    }

    private static void Values()
    {
        Json json = Json.Parse(" {\"a\": [1, -0.5, 2e3, true, false, null], \"Gr\\u00f6\\u00dfe\": \"\\ud83e\\udd94\\n\", \"t\": 1763942400000000001} ");
        Check.Equal(6, json["a"].Count, "items");
        Check.Equal(-0.5, json["a"][1].Number, "a fraction");
        Check.Equal(2000.0, json["a"][2].Number, "an exponent");
        Check.That(json["a"][3].Flag && !json["a"][4].Flag && json["a"][5].IsNull, "words");
        Check.Equal("\U0001F994\n", json["Größe"].Text, "escapes");
        Check.Equal(1763942400000000001L, json["t"].Integer, "device time");
        Check.That(json["none"]["of"][7]["this"].IsNull, "what is not there is null");
        Check.Equal("{\"a\":1e-07,\"b\":0.1,\"c\":100}", Json.Parse("{\"a\":0.0000001,\"b\":0.1,\"c\":1e2}").ToString().ToLowerInvariant(), "numbers");
        Check.Throws<ArgumentException>(() => Json.Of(double.NaN));
        Check.Throws<ArgumentException>(() => new Params().Set("level", double.PositiveInfinity));
    }

    private static void Deep()
    {
        Check.Equal(JsonKind.List, Json.Parse(new string('[', 60) + new string(']', 60)).Kind, "60 lists");
        Check.Throws<FormatException>(() => Json.Parse(new string('[', 1000000)));
    }

    private static void RoundTrips()
    {
        var random = new Random(1);
        for (int round = 0; round < 3000; ++round)
        {
            string text = Any(random, 0).ToString();
            Check.Equal(text, Json.Parse(text).ToString(), "round " + round);
            Encoding.UTF8.GetBytes(text);
        }
    }

    private static Json Any(Random random, int depth)
    {
        switch (random.Next(depth > 4 ? 5 : 7))
        {
            case 0: return Json.Null;
            case 1: return Json.Of(random.Next(2) == 0);
            case 2: return Json.Of(((long)random.Next() << 32) - random.Next());
            case 3: return Json.Of(random.NextDouble() * Math.Pow(10, random.Next(-300, 300)));
            case 4: return Json.Of(AnyText(random));
            case 5:
                var items = new Json[random.Next(4)];
                for (int i = 0; i < items.Length; ++i) items[i] = Any(random, depth + 1);
                return Json.List(items);
            default:
                var members = new List<KeyValuePair<string, Json>>();
                for (int i = random.Next(4); i > 0; --i) members.Add(new KeyValuePair<string, Json>(AnyText(random), Any(random, depth + 1)));
                return Json.Object(members);
        }
    }

    private static string AnyText(Random random)
    {
        var text = new StringBuilder();
        for (int i = random.Next(6); i > 0; --i) text.Append((char)random.Next(random.Next(2) == 0 ? 128 : 65536));
        return text.ToString();
    }

    private static void Damaged()
    {
        const string Whole = "{\"jsonrpc\":\"2.0\",\"method\":\"event\",\"params\":{\"type\":\"armed\",\"n\":[1,-2.5e3,null,\"\\u00e4\"]}}";
        var random = new Random(2);
        for (int round = 0; round < 20000; ++round)
        {
            var text = new StringBuilder(Whole);
            for (int changes = random.Next(1, 4); changes > 0; --changes)
            {
                int at = random.Next(text.Length);
                if (random.Next(2) == 0) text.Remove(at, 1);
                else text[at] = (char)random.Next(1, 128);
            }
            try
            {
                Json.Parse(text.ToString());
            }
            catch (FormatException)
            {
            }
        }
    }

    private static void Pieces()
    {
        byte[] bytes = Encoding.UTF8.GetBytes("{\"a\":\"Größe 🦔\"}\r\n\n{\"b\":2}\n{\"c\"");
        for (int size = 1; size <= bytes.Length; ++size)
        {
            var exchange = new Exchange();
            var messages = new List<Json>();
            for (int at = 0; at < bytes.Length; at += size)
            {
                var piece = new byte[Math.Min(size, bytes.Length - at)];
                Array.Copy(bytes, at, piece, 0, piece.Length);
                messages.AddRange(exchange.Receive(piece, piece.Length));
            }
            Check.Equal("{\"a\":\"Größe 🦔\"}{\"b\":2}", string.Concat(messages), "pieces of " + size);
        }
        Check.Throws<FormatException>(() => new Exchange().Receive(new byte[] { 0xff, 0x0a }, 2));
        Check.Throws<FormatException>(() => new Exchange().Receive(new byte[5 << 20], 5 << 20));
    }

    private static string Found(Dictionary<string, string> environment)
    {
        return string.Join(" ", Address.OfDaemon(null, name =>
        {
            string value;
            return environment.TryGetValue(name, out value) ? value : null;
        }, "7"));
    }

    private static void Addresses()
    {
        Check.Equal("[::1]:9", Found(new Dictionary<string, string> { { "HEDGEHOG_ADDRESS", "[::1]:9" } }), "HEDGEHOG_ADDRESS");
        Check.Equal("/run/hedgehog/hedgehogd.sock /tmp/hedgehog-7/hedgehogd.sock 127.0.0.1:7586", Found(new Dictionary<string, string>()), "nothing");
        Check.Equal("/a/hedgehogd.sock /run/hedgehog/hedgehogd.sock /u/hedgehog/hedgehogd.sock 127.0.0.1:7586",
            Found(new Dictionary<string, string> { { "RUNTIME_DIRECTORY", "/a:/b" }, { "XDG_RUNTIME_DIR", "/u" } }), "folders");
        Check.Equal("game-pc:7586", Address.Parse("game-pc").ToString(), "a host");
        Check.Equal("[::1]:7586", Address.Parse("::1").ToString(), "a bare IPv6 address");
        Check.Equal("/s", Address.Parse("unix:/s").ToString(), "a socket");
    }

    private static void NoAddresses()
    {
        foreach (string text in new[] { "tls://ball-host:7586", "mdns://", "mdns://ball-7" })
            Check.That(Check.Throws<AddressError>(() => Address.Parse(text)).Message.Contains("; hedgehogctl tunnel " + text + " "), text);
        foreach (string text in new[] { "host:x", "host:0", "[::1", "unix:", ":7", "host:70000", "host:" })
            Check.That(Check.Throws<AddressError>(() => Address.Parse(text)).Message.Contains("is no address of a daemon"), text);
    }

    private static void SilentSocket()
    {
        string path = Path.Combine(Path.GetTempPath(), "hedgehog-" + Guid.NewGuid().ToString("N"));
        using (var listener = new Socket(AddressFamily.Unix, SocketType.Stream, ProtocolType.Unspecified))
        {
            listener.Bind(new UnixEndPoint(path));
            listener.Listen(0);
            // The kernel accepts one for the program.
            Wire first = Wire.Connect(Address.Parse(path), 60000);
            try
            {
                Check.Throws<SocketException>(() => Wire.Connect(Address.Parse(path), 50));
            }
            finally
            {
                first.Close(false);
                File.Delete(path);
            }
        }
    }

    /// A daemon of one connection that sends lines; `expected`: a part of the introduction.
    private static void Serve(string expected, string lines, Action<string> play)
    {
        var listener = new TcpListener(IPAddress.Loopback, 0);
        listener.Start();
        string received = null;
        var server = new Thread(() =>
        {
            using (TcpClient client = listener.AcceptTcpClient())
            {
                var reader = new StreamReader(client.GetStream());
                received = reader.ReadLine();
                byte[] bytes = Encoding.UTF8.GetBytes("{\"id\":1,\"result\":{\"limits\":{\"current_a\":15}}}\n" + lines);
                client.GetStream().Write(bytes, 0, bytes.Length);
                reader.ReadToEnd();
            }
        });
        server.Start();
        play(listener.LocalEndpoint.ToString());
        server.Join();
        listener.Stop();
        Check.That(received.Contains(expected), received);
    }

    private static void Token()
    {
        Environment.SetEnvironmentVariable("HEDGEHOG_TOKEN", "hht_of_the_environment");
        Serve("\"token\":\"hht_of_the_environment\"", "", address => new Ball(address, timeoutS: 60).Dispose());
        Serve("\"token\":\"hht_given\"", "", address => new Ball(address, timeoutS: 60, token: "hht_given").Dispose());
        Environment.SetEnvironmentVariable("HEDGEHOG_TOKEN", null);
    }

    private static void OtherKind()
    {
        string lines = string.Concat(Enumerable.Repeat("{\"method\":\"telemetry\",\"params\":{\"limit_a\":5}}\n", 20000));
        Serve("hello", lines + "{\"method\":\"event\",\"params\":{\"type\":\"armed\"}}\n", address =>
        {
            using (var ball = new AsyncBall(address, timeoutS: 60))
            {
                ball.Open().GetAwaiter().GetResult();
                Notification next;
                Check.That(ball.Next(out next, 60, "events") && next.Method == "event", "the event");
                Check.That(!ball.Next(out next, 0, "events"), "there is one event");
                Check.That(ball.TryNext(out next) && next.Method == "telemetry", "telemetry is kept");
            }
        });
    }

    private static void Levels()
    {
        Check.Equal(0.0, Rumble.FeltLevel(0.0, 2.1, 15.0), "0");
        Check.Equal(0.0, Rumble.FeltLevel(double.NaN, 2.1, 15.0), "NaN");
        Check.That(Math.Abs(Rumble.FeltLevel(1e-9, 2.1, 15.0) - 0.14) < 1e-6, "a little");
        Check.Equal(1.0, Rumble.FeltLevel(7.0, 2.1, 15.0), "too much");
    }
}
