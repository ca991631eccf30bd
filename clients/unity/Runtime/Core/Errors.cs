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
    public sealed class RequestError : BallError
    {
        /// <summary>Of JSON-RPC or of the protocol, see ErrorCode.</summary>
        public readonly int Code;

        /// <summary>"invalid_params"; empty when the daemon names none.</summary>
        public readonly string Name;

        /// <summary>Field, limit, value and so on.</summary>
        public new readonly Results.ErrorData Data;

        public RequestError(Json error) : base(error["message"].Text ?? "")
        {
            Code = (int)error["code"].Integer;
            Data = new Results.ErrorData(error["data"]);
            Name = Data.Name ?? "";
        }
    }
}
