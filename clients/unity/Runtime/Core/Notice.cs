// SPDX-License-Identifier: MIT
using System;

namespace Hedgehog
{
    /// <summary>The error that the daemon sent last, if it answers no request: the reason for which it closes the connection.</summary>
    internal sealed class Notice
    {
        /// The longest wait until the next connection that a daemon can ask for.
        private const double MaxRetryAfterS = 60.0;

        private Json error = Json.Null;

        public void Take(Json message)
        {
            error = message["id"].IsNull ? message["error"] : Json.Null;
        }

        /// <summary>Why it has ended.</summary>
        public string Or(string otherwise)
        {
            return error["message"].Text ?? otherwise;
        }

        /// <summary>So long the daemon wants no other connection.</summary>
        public double RetryAfterS
        {
            get { return Math.Max(0.0, Math.Min(MaxRetryAfterS, 0.001 * error["data"]["retry_after_ms"].Number)); }
        }
    }
}
