// SPDX-License-Identifier: MIT
using System;

/// What a test expects; the first that is not so ends it.
internal static class Check
{
    public static void That(bool holds, string what)
    {
        if (!holds) throw new Exception("not so: " + what);
    }

    public static void Equal(object expected, object found, string what)
    {
        That(Equals(expected, found), what + ": " + found + " instead of " + expected);
    }

    public static T Throws<T>(Action action) where T : Exception
    {
        try
        {
            action();
        }
        catch (T error)
        {
            return error;
        }
        throw new Exception("nothing was thrown");
    }

    /// Runs a test and says how it went; whether it went well.
    public static bool Run(string name, Action test)
    {
        try
        {
            test();
            Console.WriteLine("ok      " + name);
            return true;
        }
        catch (Exception error)
        {
            Console.WriteLine("FAILED  " + name + ": " + error);
            return false;
        }
    }
}
