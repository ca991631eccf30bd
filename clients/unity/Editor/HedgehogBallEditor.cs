// SPDX-License-Identifier: MIT
using Hedgehog.Unity;
using UnityEditor;
using UnityEngine;

namespace Hedgehog.Editor
{
    /// <summary>Shows whether the ball is there, and plays a push on a click.</summary>
    [CustomEditor(typeof(HedgehogBall))]
    public sealed class HedgehogBallEditor : UnityEditor.Editor
    {
        public override bool RequiresConstantRepaint()
        {
            return Application.isPlaying;
        }

        public override void OnInspectorGUI()
        {
            DrawDefaultInspector();
            var ball = (HedgehogBall)target;
            if (!Application.isPlaying || ball.Client == null)
            {
                EditorGUILayout.HelpBox("Play mode connects. Without a ball: hedgehogd --simulate", MessageType.Info);
                return;
            }
            Results.Hello hello = ball.Client.Hello;
            if (hello == null)
            {
                EditorGUILayout.HelpBox(ball.Problem, MessageType.Warning);
                return;
            }
            EditorGUILayout.HelpBox("Connected to " + hello.Device.Name + ", up to " + hello.Limits.CurrentA + " A", MessageType.Info);
            Push(ball, "Push left", Vector3.left);
            Push(ball, "Push right", Vector3.right);
            Push(ball, "Push front", Vector3.forward);
            Push(ball, "Push up", Vector3.up);
        }

        private static void Push(HedgehogBall ball, string label, Vector3 direction)
        {
            if (GUILayout.Button(label)) ball.Pulse(direction, 0.5f);
        }
    }
}
