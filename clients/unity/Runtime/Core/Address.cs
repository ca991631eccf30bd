// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;
using System.Globalization;

namespace Hedgehog
{
    /// <summary>A host and a port, or the path of a Unix socket.</summary>
    public sealed class Address
    {
        public const int DefaultPort = 7586;
        private const string SocketName = "/hedgehogd.sock";

        /// <summary>null: a Unix socket.</summary>
        public readonly string Host;
        public readonly int Port;
        public readonly string Path;

        private Address(string host, int port, string path)
        {
            Host = host;
            Port = port;
            Path = path;
        }

        public override string ToString()
        {
            if (Path != null) return Path;
            string port = Port.ToString(CultureInfo.InvariantCulture);
            return Host.IndexOf(':') >= 0 ? "[" + Host + "]:" + port : Host + ":" + port;
        }

        /// <summary>"host", "host:port", "[v6]:port", a bare IPv6 address or "/path", each with "tcp:" or "unix:" in front.
        /// Throws AddressError.</summary>
        public static Address Parse(string text)
        {
            if (text.StartsWith("unix:", StringComparison.Ordinal) || text.StartsWith("/", StringComparison.Ordinal))
            {
                string path = text[0] == '/' ? text : text.Substring(5);
                if (path.Length == 0) throw Bad(text, "it names no socket");
                return new Address(null, 0, path);
            }
            if (text.StartsWith("tls://", StringComparison.Ordinal) || text.StartsWith("mdns://", StringComparison.Ordinal))
                throw Bad(text, "this library supports neither TLS nor discovery; hedgehogctl tunnel " + text + " makes it 127.0.0.1:7586");
            string place = text.StartsWith("tcp:", StringComparison.Ordinal) ? text.Substring(4) : text;
            string host = place;
            string rest = "";
            int colon = place.IndexOf(':');
            if (place.StartsWith("[", StringComparison.Ordinal))
            {
                int close = place.IndexOf(']');
                if (close < 0) throw Bad(text, "']' is missing");
                host = place.Substring(1, close - 1);
                rest = place.Substring(close + 1);
            }
            else if (colon >= 0 && colon == place.LastIndexOf(':'))
            {
                host = place.Substring(0, colon);
                rest = place.Substring(colon);
            }
            if (host.Length == 0) throw Bad(text, "it names no host");
            if (rest.Length == 0) return new Address(host, DefaultPort, null);
            int port;
            if (rest[0] != ':' || !int.TryParse(rest.Substring(1), NumberStyles.None, CultureInfo.InvariantCulture, out port) ||
                port < 1 || port > 65535)
                throw Bad(text, "the port is a number from 1 to 65535");
            return new Address(host, port, null);
        }

        /// <summary>Of this process, as every client of Hedgehog finds the daemon. Throws AddressError.</summary>
        public static List<Address> OfDaemon(string given = null)
        {
            return OfDaemon(given, Environment.GetEnvironmentVariable, UserId());
        }

        /// <summary>In the order in which they are tried: `given` or HEDGEHOG_ADDRESS and nowhere else; otherwise the sockets in
        /// RUNTIME_DIRECTORY, /run/hedgehog and XDG_RUNTIME_DIR/hedgehog (/tmp/hedgehog-UID without these variables), then
        /// 127.0.0.1:7586. `userId` null: not known.</summary>
        public static List<Address> OfDaemon(string given, Func<string, string> environment, string userId)
        {
            var addresses = new List<Address>();
            string text = string.IsNullOrEmpty(given) ? environment("HEDGEHOG_ADDRESS") : given;
            if (!string.IsNullOrEmpty(text))
            {
                addresses.Add(Parse(text));
                return addresses;
            }
            // Windows has none of these folders.
            if (System.IO.Path.DirectorySeparatorChar == '/')
            {
                string runtime = environment("RUNTIME_DIRECTORY");
                string session = environment("XDG_RUNTIME_DIR");
                // systemd may name several, separated by colons: the first is the daemon's.
                if (!string.IsNullOrEmpty(runtime)) Add(addresses, runtime.Split(':')[0]);
                Add(addresses, "/run/hedgehog");
                if (!string.IsNullOrEmpty(session)) Add(addresses, session + "/hedgehog");
                else if (string.IsNullOrEmpty(runtime) && userId != null) Add(addresses, "/tmp/hedgehog-" + userId);
            }
            addresses.Add(new Address("127.0.0.1", DefaultPort, null));
            return addresses;
        }

        /// Without native code there is no getuid; Linux tells it in a file.
        private static string UserId()
        {
            try
            {
                foreach (string line in System.IO.File.ReadAllLines("/proc/self/status"))
                    if (line.StartsWith("Uid:", StringComparison.Ordinal)) return line.Split('\t')[1];
            }
            catch (System.IO.IOException)
            {
            }
            catch (UnauthorizedAccessException)
            {
            }
            return null;
        }

        private static void Add(List<Address> addresses, string folder)
        {
            string path = folder + SocketName;
            foreach (var known in addresses)
                if (known.Path == path) return;
            addresses.Add(new Address(null, 0, path));
        }

        private static AddressError Bad(string text, string why)
        {
            return new AddressError("'" + text + "' is no address of a daemon: " + why +
                " (for example 127.0.0.1:7586, [::1]:7586 or /run/hedgehog/hedgehogd.sock)");
        }
    }
}
