// SPDX-License-Identifier: MIT
using System;

namespace Hedgehog
{
    /// <summary>Any of the below; the message is a sentence for people.</summary>
    public class BallError : Exception
    {
        public BallError(string message) : base(message)
        {
        }
    }

    /// <summary>HEDGEHOG_ADDRESS, or the address that was given, is none.</summary>
    public sealed class AddressError : BallError
    {
        public AddressError(string message) : base(message)
        {
        }
    }

    /// <summary>No daemon answers, or the connection has ended. The next call tries again, no earlier than after RetryAfterS.</summary>
    public sealed class NotConnected : BallError
    {
        public readonly double RetryAfterS;

        public NotConnected(string message, double retryAfterS = 0.0) : base(message)
        {
            RetryAfterS = retryAfterS;
        }
    }

    /// <summary>The daemon refused a request.</summary>
    public class RequestError : BallError
    {
        /// <summary>Of JSON-RPC or of the protocol, see ErrorCode.</summary>
        public readonly int Code;

        /// <summary>"invalid_params"; empty when the daemon names none.</summary>
        public readonly string Name;

        /// <summary>Field, limit, value and so on.</summary>
        public new readonly Results.ErrorData Data;

        public RequestError(Json error) : this(error, "")
        {
        }

        protected RequestError(Json error, string before) : base(before + (error["message"].Text ?? ""))
        {
            Code = (int)error["code"].Integer;
            Data = new Results.ErrorData(error["data"]);
            Name = Data.Name ?? "";
        }
    }

    /// <summary>The daemon refused to renew a subscription on a new connection; it has ended. The message begins with the method.
    /// </summary>
    public sealed class SubscriptionEnded : RequestError
    {
        /// <summary>"events.subscribe".</summary>
        public readonly string Method;

        public SubscriptionEnded(string method, Json error) : base(error, method + ": ")
        {
            Method = method;
        }
    }
}
