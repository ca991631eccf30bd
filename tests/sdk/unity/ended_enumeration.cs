// SPDX-License-Identifier: MIT
// Enumerations of a Ball whose other calls have connected it again meanwhile, to a daemon that refuses one of the subscriptions.
using System.Diagnostics;
using System.Linq;
using Hedgehog;

internal static partial class Conformance
{
    private static void EndedEnumeration()
    {
        string address;
        using (Process daemon = Start("a subscription that the next daemon refuses has ended, and is reported", out address))
        {
            var library = new BlockingLibrary();
            library.Open(address, TimeoutS);
            var events = library.Ball.Events(scope: Scope.All);
            var telemetry = library.Ball.Telemetry(5, timeoutS: 0);
            Check.Throws<NotConnected>(() => library.Call("ping", null));
            Again(library, "ping");
            var ended = Check.Throws<SubscriptionEnded>(() => events.First());
            Check.Equal("events.subscribe", ended.Method, "the method");
            Check.Equal("events.subscribe: not any more", ended.Message, "the sentence");
            Check.Equal(0, telemetry.Count(), "telemetry goes on");
            Check.Throws<NotConnected>(() => library.Call("ping", null));
            Again(library, "ping");
            library.Close();
            Finish(daemon);
        }
    }
}
