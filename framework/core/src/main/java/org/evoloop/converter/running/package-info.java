/**
 * A converter at work: the shell around the deterministic core.
 *
 * <pre>
 *  monitor, clock ─▶ loop ─▶ CoreIntake ─┐  inputs                        outputs
 *                                        ├─────────▶ CoreDriver (core) ─────────▶ CoreOutputs ─▶ recording
 *  execute component ─▶ PlanExecutor ────┘                                           │
 *            ▲              ▲                                                        ▼ directives
 *            └──────────────┴─────────────────────────────────────────────────── Agenda
 * </pre>
 *
 * <ul>
 *   <li>{@link org.evoloop.converter.running.ConverterShell}: puts the parts together, and attaches the components.
 *   <li>{@link org.evoloop.converter.running.CoreDriver}: the core and the lock that guards it; {@link
 *       org.evoloop.converter.running.CoreIntake} and {@link org.evoloop.converter.running.CoreOutputs} are its two sides.
 *   <li>{@link org.evoloop.converter.running.PlanExecutor}, {@link org.evoloop.converter.running.Agenda} and {@link
 *       org.evoloop.converter.running.Senders}: who carries out what the core asks for; {@link
 *       org.evoloop.converter.running.PlanCheck} refuses what a component has planned wrong.
 *   <li>{@link org.evoloop.converter.running.Visits}: timers and new functions.
 *   <li>{@link org.evoloop.converter.running.Hooks}: calls components while the converter opens and closes.
 *   <li>{@link org.evoloop.converter.running.SentryFeed}: feeds a sentry.
 *   <li>{@link org.evoloop.converter.running.ShadowCore} and {@link org.evoloop.converter.running.ShadowedInputs}: other
 *       models beside the running ones.
 *   <li>{@link org.evoloop.converter.running.Assembly}, {@link org.evoloop.converter.running.CurrentKnowledge} and {@link
 *       org.evoloop.converter.running.ControllerEvents}: the components and the knowledge, and what follows from them.
 * </ul>
 *
 * <p>No module exports this package. It may use {@code org.evoloop.converter.recording}, {@code converter}, {@code
 * converter.attachment}, {@code engine}, {@code rehearsal}, {@code function.visit} and what those use.
 */
@NullMarked
package org.evoloop.converter.running;

import org.jspecify.annotations.NullMarked;
