// SPDX-License-Identifier: MIT
// A way to the daemon that can be cut and comes back at the same address.
using System;
using System.Collections.Generic;
using System.IO;
using System.Net;
using System.Net.Sockets;
using System.Threading;

internal sealed class Relay : IDisposable
{
    private readonly TcpListener listener = new TcpListener(IPAddress.Loopback, 0);
    private readonly List<TcpClient> open = new List<TcpClient>();
    private readonly string host;
    private readonly int port;
    private bool refuses;
    private int lines;

    /// Lines that clients have sent.
    public int Lines
    {
        get { return Volatile.Read(ref lines); }
    }

    public Relay(string address)
    {
        string[] parts = address.Split(':');
        host = parts[0];
        port = int.Parse(parts[1]);
        listener.Start();
        Start(() =>
        {
            for (;;) Join(listener.AcceptTcpClient());
        });
    }

    public string Address
    {
        get { return listener.LocalEndpoint.ToString(); }
    }

    /// Ends all connections; new ones end at once.
    public void Refuse()
    {
        lock (open)
        {
            refuses = true;
            foreach (var one in open) one.Close();
            open.Clear();
        }
    }

    public void Accept()
    {
        lock (open) refuses = false;
    }

    public void Dispose()
    {
        Refuse();
        listener.Stop();
    }

    private void Join(TcpClient near)
    {
        lock (open)
        {
            if (refuses)
            {
                near.Close();
                return;
            }
            var far = new TcpClient(host, port) { NoDelay = true };
            near.NoDelay = true;
            open.Add(near);
            open.Add(far);
            NetworkStream there = far.GetStream(), here = near.GetStream();
            Start(() => Forward(here, there));
            Start(() => there.CopyTo(here));
        }
    }

    private void Forward(NetworkStream from, NetworkStream to)
    {
        var bytes = new byte[1 << 16];
        for (int count = from.Read(bytes, 0, bytes.Length); count > 0; count = from.Read(bytes, 0, bytes.Length))
        {
            for (int i = 0; i < count; ++i)
                if (bytes[i] == (byte)'\n') Interlocked.Increment(ref lines);
            to.Write(bytes, 0, count);
        }
    }

    /// Ends with its socket.
    private static void Start(Action work)
    {
        new Thread(() =>
        {
            try
            {
                work();
            }
            catch (IOException)
            {
            }
            catch (SocketException)
            {
            }
            catch (ObjectDisposedException)
            {
            }
        }) { IsBackground = true }.Start();
    }
}
