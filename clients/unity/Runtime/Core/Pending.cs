// SPDX-License-Identifier: MIT
using System;
using System.Threading;
using System.Threading.Tasks;

namespace Hedgehog
{
    /// <summary>A response that is still to come, and its time-out.</summary>
    internal sealed class Pending
    {
        private readonly TaskCompletionSource<Json> response =
            new TaskCompletionSource<Json>(TaskCreationOptions.RunContinuationsAsynchronously);
        private readonly Timer timer;

        public readonly Subscriptions.Change Change;

        public Pending(Subscriptions.Change change, int timeoutMs, Action tooLate)
        {
            Change = change;
            timer = new Timer(unused => tooLate(), null, timeoutMs, Timeout.Infinite);
        }

        public Task<Json> Response
        {
            get { return response.Task; }
        }

        public void Answer(Json message)
        {
            timer.Dispose();
            Json error = message["error"];
            if (error.IsNull) response.TrySetResult(message["result"]);
            else response.TrySetException(new RequestError(error));
        }

        public void Fail(BallError why)
        {
            timer.Dispose();
            response.TrySetException(why);
        }
    }
}
