// SPDX-License-Identifier: MIT
// As much of Unity's own classes as clients/unity uses, so that it compiles and runs without Unity.
using System;
using System.Reflection;

namespace UnityEngine
{
    public struct Vector3
    {
        public float x, y, z;

        public Vector3(float x, float y, float z)
        {
            this.x = x;
            this.y = y;
            this.z = z;
        }

        public float magnitude
        {
            get { return (float)Math.Sqrt(x * x + y * y + z * z); }
        }

        public static readonly Vector3 left = new Vector3(-1, 0, 0);
        public static readonly Vector3 right = new Vector3(1, 0, 0);
        public static readonly Vector3 up = new Vector3(0, 1, 0);
        public static readonly Vector3 down = new Vector3(0, -1, 0);
        public static readonly Vector3 back = new Vector3(0, 0, -1);
        public static readonly Vector3 forward = new Vector3(0, 0, 1);
    }

    public class Transform
    {
        public Vector3 InverseTransformDirection(Vector3 v)
        {
            return v;
        }

        public Vector3 InverseTransformPoint(Vector3 v)
        {
            return v;
        }
    }

    public class MonoBehaviour
    {
        public readonly Transform transform = new Transform();

        /// As Unity calls the messages of a script, whoever may.
        public void Message(string name, params object[] arguments)
        {
            GetType().GetMethod(name, BindingFlags.Instance | BindingFlags.NonPublic | BindingFlags.Public).Invoke(this, arguments);
        }

        /// As the inspector sets a field.
        public void Set(string field, object value)
        {
            GetType().GetField(field, BindingFlags.Instance | BindingFlags.NonPublic).SetValue(this, value);
        }
    }

    public struct ContactPoint
    {
        public Vector3 point;
    }

    public class Collision
    {
        public Vector3 impulse;
        public ContactPoint contact;

        public ContactPoint GetContact(int index)
        {
            return contact;
        }
    }

    public static class Application
    {
        public static bool isPlaying = true;
        public static string productName = "stub";
    }

    public static class Debug
    {
        public static string warned = "";

        public static void LogWarning(object message, MonoBehaviour context)
        {
            warned = message.ToString();
        }
    }

    public static class Time
    {
        public static float time;
    }

    public static class GUILayout
    {
        public static string pressed = "";

        public static bool Button(string label)
        {
            return label == pressed;
        }
    }

    [AttributeUsage(AttributeTargets.Field)]
    public sealed class SerializeField : Attribute
    {
    }

    [AttributeUsage(AttributeTargets.Field)]
    public sealed class TooltipAttribute : Attribute
    {
        public TooltipAttribute(string text)
        {
        }
    }

    [AttributeUsage(AttributeTargets.Field)]
    public sealed class RangeAttribute : Attribute
    {
        public RangeAttribute(float min, float max)
        {
        }
    }

    [AttributeUsage(AttributeTargets.Class)]
    public sealed class AddComponentMenu : Attribute
    {
        public AddComponentMenu(string name)
        {
        }
    }

    [AttributeUsage(AttributeTargets.Class)]
    public sealed class DisallowMultipleComponent : Attribute
    {
    }
}

namespace UnityEditor
{
    public enum MessageType
    {
        None,
        Info,
        Warning,
        Error
    }

    [AttributeUsage(AttributeTargets.Class)]
    public sealed class CustomEditor : Attribute
    {
        public CustomEditor(Type of)
        {
        }
    }

    public class Editor
    {
        public object target;

        public bool DrawDefaultInspector()
        {
            return false;
        }

        public virtual bool RequiresConstantRepaint()
        {
            return false;
        }

        public virtual void OnInspectorGUI()
        {
        }
    }

    public static class EditorGUILayout
    {
        public static string shown = "";

        public static void HelpBox(string text, MessageType kind)
        {
            shown = text;
        }
    }
}
