// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;
using System.Net;
using System.Net.Sockets;
using System.Threading;

namespace Hedgehog
{
    /// <summary>A connected socket whose sender never waits: a thread of its own writes. Any thread.</summary>
    internal sealed class Wire
    {
        /// More than this waits to be written only when the daemon does not read.
        private const int MaxQueued = 4096;
        /// The longest that closing waits for what is still to be written.
        private const int FlushMs = 500;

        private readonly object gate = new object();
        private readonly Queue<byte[]> queue = new Queue<byte[]>();
        private readonly Socket socket;
        private readonly Thread writer;
        private bool closing;

        private Wire(Socket socket)
        {
            this.socket = socket;
            writer = new Thread(Write) { IsBackground = true, Name = "Hedgehog writer" };
            writer.Start();
        }

        /// <summary>Waits, altogether no longer than that. Throws SocketException, or ArgumentException for a path that is too long.</summary>
        public static Wire Connect(Address address, int timeoutMs)
        {
            if (address.Path != null) return new Wire(Open(new UnixEndPoint(address.Path), timeoutMs));
            Deadline deadline = Deadline.After(timeoutMs);
            IPAddress[] found = Find(address.Host, deadline);
            return new Wire(First(found, deadline, (one, ms) => Open(new IPEndPoint(one, address.Port), ms)));
        }

        /// <summary>Of the addresses of a name the first that answers. open: with a time limit in ms.</summary>
        internal static Socket First(IPAddress[] found, Deadline deadline, Func<IPAddress, int, Socket> open)
        {
            SocketException last = new SocketException((int)SocketError.HostNotFound);
            for (int i = 0; i < found.Length; ++i)
            {
                try
                {
                    return open(found[i], deadline.ShareMs(found.Length - i));
                }
                catch (SocketException error)
                {
                    last = error;
                }
            }
            throw last;
        }

        /// <summary>False: nothing was sent; the daemon does not read, or this is closed.</summary>
        public bool Send(byte[] line)
        {
            lock (gate)
            {
                if (closing || queue.Count >= MaxQueued) return false;
                queue.Enqueue(line);
                Monitor.Pulse(gate);
                return true;
            }
        }

        /// <summary>Waits for bytes. 0: the connection has ended. Throws SocketException.</summary>
        public int Receive(byte[] bytes)
        {
            try
            {
                return socket.Receive(bytes);
            }
            catch (ObjectDisposedException)
            {
                return 0;
            }
        }

        /// <summary>`flush`: what was sent is written first, as far as the daemon takes it.</summary>
        public void Close(bool flush)
        {
            lock (gate)
            {
                closing = true;
                if (!flush) queue.Clear();
                Monitor.Pulse(gate);
            }
            if (flush && Thread.CurrentThread != writer) writer.Join(FlushMs);
            Shut();
            socket.Close();
        }

        private void Shut()
        {
            try
            {
                // Wakes the thread that receives, which closing alone does not everywhere.
                socket.Shutdown(SocketShutdown.Both);
            }
            catch (SocketException)
            {
            }
            catch (ObjectDisposedException)
            {
            }
        }

        private void Write()
        {
            try
            {
                for (byte[] line = Next(); line != null; line = Next())
                    for (int sent = 0; sent < line.Length;)
                        sent += socket.Send(line, sent, line.Length - sent, SocketFlags.None);
            }
            catch (SocketException)
            {
                // What the daemon sent before is still read.
                Shut();
            }
            catch (ObjectDisposedException)
            {
            }
        }

        /// null: nothing will come any more.
        private byte[] Next()
        {
            lock (gate)
            {
                while (queue.Count == 0 && !closing) Monitor.Wait(gate);
                return queue.Count > 0 ? queue.Dequeue() : null;
            }
        }

        /// A name server that does not answer has another thread wait.
        private static IPAddress[] Find(string host, Deadline deadline)
        {
            IPAddress literal;
            if (IPAddress.TryParse(host, out literal)) return new[] { literal };
            IAsyncResult looking = Dns.BeginGetHostAddresses(host, null, null);
            if (!looking.AsyncWaitHandle.WaitOne(deadline.ShareMs())) throw new SocketException((int)SocketError.TimedOut);
            return Dns.EndGetHostAddresses(looking);
        }

        private static Socket Open(EndPoint place, int timeoutMs)
        {
            bool isUnix = place.AddressFamily == AddressFamily.Unix;
            var socket = new Socket(place.AddressFamily, SocketType.Stream, isUnix ? ProtocolType.Unspecified : ProtocolType.Tcp);
            try
            {
                if (isUnix)
                {
                    // Of connecting too, which waits while the daemon's queue of clients is full.
                    socket.SendTimeout = timeoutMs;
                    socket.Connect(place);
                    socket.SendTimeout = 0;
                    return socket;
                }
                IAsyncResult connecting = socket.BeginConnect(place, null, null);
                if (!connecting.AsyncWaitHandle.WaitOne(timeoutMs)) throw new SocketException((int)SocketError.TimedOut);
                socket.EndConnect(connecting);
                // A game's small lines must not wait for each other's acknowledgement.
                socket.NoDelay = true;
                return socket;
            }
            catch (Exception)
            {
                socket.Close();
                throw;
            }
        }
    }
}
