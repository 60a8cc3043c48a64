package org.evoloop.console;

import java.time.Instant;
import java.util.Locale;
import org.evoloop.converter.ConverterStatus;
import org.evoloop.converter.Drift;
import org.evoloop.loop.ComponentStatus;
import org.evoloop.payload.JsonObject;
import org.jspecify.annotations.Nullable;

/**
 * The status of a converter for programs: one line of JSON. Every key is always there:
 *
 * <ul>
 *   <li>{@code name}; {@code loop}: new, stopped, running or exited
 *   <li>{@code originalState}, {@code newState}: the current states of the models
 *   <li>{@code system}: the latter for people, with where the device is if the state needs it somewhere: {@code Gap, the
 *   device in StopUp}
 *   <li>{@code lastKnownSince}: since when these are only the last known ones, in UTC, such as {@code
 *   2026-11-22T15:04:05.123Z}; {@code null} while the loop is open and the device can be reached
 *   <li>{@code queue}: {@code depth}, {@code capacity}, {@code highest}, {@code taken}, {@code dropped}, {@code
 *   refused}
 *   <li>{@code events}, all at one moment: {@code observed}, which is the sum of {@code handled}, {@code ignored}, {@code
 *   stale}, {@code failed}, {@code dropped}, {@code refused}, {@code waiting} and {@code inProgress}
 *   <li>{@code conversionTime}: {@code events}, {@code lastNanos}, {@code medianNanos}, {@code percentile99Nanos}
 *   <li>{@code components}, a list: {@code name}, {@code role} (monitor, analyze, plan, execute), {@code thread},
 *   {@code activity} (waiting, working, stuck, ended), {@code failures}, {@code lastFailure}
 *   <li>{@code evolution}: which models took over from which, as long as a rollback is possible; else empty
 *   <li>{@code shadow}: the report of the shadow, as text; empty if there is none
 *   <li>{@code doubt}: why the original state may be wrong, empty if it is certain
 *   <li>{@code drift}, what the device did lately that its model does not have: {@code acts}, {@code unexplained}, {@code
 *   text}, empty if all is in the model, and {@code edges}, a list of {@code edge} and {@code count}
 *   <li>{@code function}: {@code state}, {@code thread}, {@code progress} in words, {@code readings} as below; all
 *   empty if no new function runs
 *   <li>{@code timers}, those of the new model's state, the next one first: {@code event}, {@code remainingMillis},
 *   {@code due} in UTC
 *   <li>{@code faults}, a list of failed parts other than components, such as a guard or a function: {@code part},
 *   {@code failures}, {@code lastFailure}
 *   <li>{@code link}: {@code up}, {@code text}, {@code readings}, an object with a member for each thing known
 *   of the device, such as {@code "battery":93}; {@code null} if no link was registered
 * </ul>
 *
 * <p>Threading: any thread may call it.
 *
 * @since 0.1
 */
public final class StatusJson {
    private StatusJson() {}

    /** The line. */
    public static JsonObject of(ConverterStatus status) {
        return new JsonObject()
                .put("name", status.name())
                .put("loop", lowerCase(status.loop()))
                .put("originalState", status.states().original().name())
                .put("newState", status.states().evolved().name())
                .put("system", status.system())
                .put("evolution", status.evolution())
                .put("shadow", status.shadow())
                .put("doubt", status.doubt())
                .put("drift", drift(status.drift()))
                .put(
                        "lastKnownSince",
                        status.lastKnownSince().map(Instant::toString).orElse(null))
                .put(
                        "queue",
                        new JsonObject()
                                .put("depth", status.queue().depth())
                                .put("capacity", status.queue().capacity())
                                .put("highest", status.queue().highest())
                                .put("taken", status.queue().taken())
                                .put("dropped", status.queue().dropped())
                                .put("refused", status.queue().refused()))
                .put(
                        "events",
                        new JsonObject()
                                .put("observed", status.events().observed())
                                .put("handled", status.events().handled())
                                .put("ignored", status.events().ignored())
                                .put("stale", status.events().stale())
                                .put("failed", status.events().failed())
                                .put("dropped", status.events().dropped())
                                .put("refused", status.events().refused())
                                .put("waiting", status.events().waiting())
                                .put("inProgress", status.events().inProgress()))
                .put(
                        "conversionTime",
                        new JsonObject()
                                .put("events", status.conversionTime().events())
                                .put("lastNanos", status.conversionTime().lastNanos())
                                .put("medianNanos", status.conversionTime().medianNanos())
                                .put(
                                        "percentile99Nanos",
                                        status.conversionTime().percentile99Nanos()))
                .put(
                        "components",
                        status.components().stream().map(StatusJson::component).toList())
                .put(
                        "function",
                        new JsonObject()
                                .put("state", status.function().state())
                                .put("thread", status.function().thread())
                                .put("progress", status.function().progress())
                                .put("readings", JsonObject.of(status.function().readings())))
                .put("timers", status.timers().stream().map(StatusJson::timer).toList())
                .put("faults", status.faults().stream().map(StatusJson::fault).toList())
                .put("link", link(status.link()));
    }

    private static JsonObject drift(Drift drift) {
        return new JsonObject()
                .put("acts", drift.acts())
                .put("unexplained", drift.unexplained())
                .put("text", drift.toString())
                .put(
                        "edges",
                        drift.edges().stream()
                                .map(edge -> new JsonObject()
                                        .put("edge", edge.toString())
                                        .put("count", edge.count()))
                                .toList());
    }

    private static @Nullable JsonObject link(ConverterStatus.@Nullable LinkStatus link) {
        return link == null
                ? null
                : new JsonObject()
                        .put("up", link.up())
                        .put("text", link.text())
                        .put("readings", JsonObject.of(link.readings()));
    }

    private static JsonObject component(ComponentStatus component) {
        return new JsonObject()
                .put("name", component.name())
                .put("role", lowerCase(component.role()))
                .put("thread", component.thread())
                .put("activity", lowerCase(component.activity()))
                .put("failures", component.failures())
                .put("lastFailure", component.lastFailure());
    }

    private static JsonObject timer(ConverterStatus.RunningTimer timer) {
        return new JsonObject()
                .put("event", timer.event())
                .put("remainingMillis", timer.remaining().toMillis())
                .put("due", timer.due().toString());
    }

    private static JsonObject fault(ConverterStatus.Fault fault) {
        return new JsonObject()
                .put("part", fault.part())
                .put("failures", fault.failures())
                .put("lastFailure", fault.lastFailure());
    }

    static String lowerCase(Enum<?> constant) {
        return constant.name().toLowerCase(Locale.ROOT);
    }
}
