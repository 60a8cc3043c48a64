package org.evoloop.device;

import java.io.PrintStream;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import org.evoloop.console.ConsoleCommand;
import org.evoloop.converter.DeviceLink;
import org.evoloop.converter.Evolution;
import org.evoloop.converter.StateKnowledge;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.device.file.DeviceFileException;
import org.evoloop.evolution.ModelPair;
import org.evoloop.migration.Mapping;
import org.evoloop.statemachine.Names;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;

/**
 * The command {@code reload}: a running converter takes over what has changed in its device file.
 *
 * <p>Threading: thread-safe.
 */
final class Reload {
    private final SystemEventConverter converter;
    private final List<DeviceLink> links;
    private final Deque<DeviceFile> read = new ArrayDeque<>();

    /** @param links for the guards */
    Reload(DeviceFile first, SystemEventConverter converter, List<DeviceLink> links) {
        this.converter = converter;
        this.links = List.copyOf(links);
        read.push(first);
    }

    ConsoleCommand command() {
        return ConsoleCommand.of(
                "reload",
                "reads the device file again, and takes over its models, functions, guards and effects",
                (arguments, out) -> reload(out));
    }

    /** The knowledge of these models, with the functions of the last file that had them, else of the last one. */
    synchronized StateKnowledge knowledge(ModelPair models) {
        return read.stream()
                .filter(file -> file.models().equals(models))
                .findFirst()
                .orElseGet(read::getFirst)
                .knowledge(models);
    }

    private synchronized void reload(PrintStream out) {
        DeviceFile before = read.getFirst();
        DeviceFile next;
        try {
            next = before.readAgain(DeviceProgram.options());
        } catch (DeviceFileException mistakes) {
            throw new IllegalArgumentException(mistakes.getMessage(), mistakes);
        }
        requireSameDevice(before, next);
        next.guards().attach(converter.clock(), links);
        Evolution.Result result = converter.evolve(Evolution.to(next.knowledge(next.models()))
                .withMapping(mapping(before, next))
                .withoutWayBack()
                .tellingWaits(why -> ConsoleCommand.sayAtOnce(why, out)));
        read.push(next);
        out.println(
                Names.inOneLine("evolved to '" + result.model() + "': " + result.before() + " is " + result.after()));
    }

    private static void requireSameDevice(DeviceFile before, DeviceFile next) {
        boolean isPlayed = before.connections().stream().allMatch(Connection::isPlayed);
        if (isPlayed && !before.models().original().equals(next.models().original())) {
            throw new IllegalArgumentException(
                    "the original model has changed, by which --simulate plays the device;" + " exit, and start again");
        }
    }

    /** Of the states that were assumed without models, those that the models lack become the initial one. */
    private static Mapping mapping(DeviceFile before, DeviceFile next) {
        Mapping mapping = Mapping.byName();
        if (before.references().isEmpty()) {
            StateMachine device = next.models().original();
            State initial = next.models().evolved().initial();
            for (State assumed : before.models().original().states()) {
                if (!device.hasState(assumed)) {
                    mapping = mapping.withDeviceState(assumed, device.initial()).withState(assumed, initial);
                }
            }
        }
        return mapping;
    }
}
