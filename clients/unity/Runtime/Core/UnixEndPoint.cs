// SPDX-License-Identifier: MIT
using System.Net;
using System.Net.Sockets;
using System.Text;

namespace Hedgehog
{
    /// <summary>A path as the system's calls take it (sockaddr_un); .NET Standard 2.0 has no such class.</summary>
    internal sealed class UnixEndPoint : EndPoint
    {
        private const int FamilyBytes = 2;

        private readonly byte[] path;

        public UnixEndPoint(string path)
        {
            this.path = Encoding.UTF8.GetBytes(path);
        }

        public override AddressFamily AddressFamily
        {
            get { return AddressFamily.Unix; }
        }

        public override EndPoint Create(SocketAddress socketAddress)
        {
            // Of the peer, which nobody asks for.
            return this;
        }

        public override SocketAddress Serialize()
        {
            var address = new SocketAddress(AddressFamily.Unix, FamilyBytes + path.Length + 1);
            for (int i = 0; i < path.Length; ++i) address[FamilyBytes + i] = path[i];
            address[FamilyBytes + path.Length] = 0;
            return address;
        }
    }
}
