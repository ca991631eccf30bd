// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;
using System.IO;
using System.Text;

namespace Hedgehog
{
    /// <summary>The protocol without a socket: requests to lines, bytes to messages. One thread at a time.</summary>
    internal sealed class Exchange
    {
        /// The longest line that a daemon sends is the response to a batch; this client sends none.
        private const int MaxLine = 4 << 20;

        private static readonly Encoding Utf8 = new UTF8Encoding(false, true);

        private readonly MemoryStream partial = new MemoryStream();

        /// <summary>`id` 0: a request that is not answered.</summary>
        public static byte[] Line(long id, string method, Params parameters)
        {
            var message = new Params().Set("jsonrpc", "2.0").Set("id", id == 0 ? (long?)null : id).Set("method", method);
            if (parameters != null && parameters.Count > 0) message.Set("params", parameters.Json);
            return Utf8.GetBytes(message.Json + "\n");
        }

        /// <summary>The messages that are complete with these bytes. Throws FormatException when what came is no JSON-RPC.</summary>
        public List<Json> Receive(byte[] bytes, int count)
        {
            var messages = new List<Json>();
            int start = 0;
            for (int i = 0; i < count; ++i)
            {
                if (bytes[i] != (byte)'\n') continue;
                partial.Write(bytes, start, i - start);
                start = i + 1;
                string line = TakeLine();
                if (line.Length > 0) messages.Add(Message(line));
            }
            partial.Write(bytes, start, count - start);
            if (partial.Length > MaxLine) throw new FormatException("a line of more than 4 MiB");
            return messages;
        }

        private string TakeLine()
        {
            string line;
            try
            {
                line = Utf8.GetString(partial.GetBuffer(), 0, (int)partial.Length).Trim();
            }
            catch (ArgumentException)
            {
                throw new FormatException("bytes that are no UTF-8");
            }
            partial.SetLength(0);
            return line;
        }

        private static Json Message(string line)
        {
            Json message = Json.Parse(line);
            if (message.Kind != JsonKind.Object) throw new FormatException("a message that is no object");
            return message;
        }
    }
}
