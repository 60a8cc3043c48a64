package org.evoloop.mqtt;

import java.io.OutputStream;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.evoloop.Machines;
import org.evoloop.converter.ConverterListener;
import org.evoloop.converter.HistoryEntry;
import org.evoloop.converter.StateKnowledge;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.evolution.ModelPair;
import org.evoloop.loop.LoopConfig;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.time.SystemClock;

/**
 * The converter of a device that any of many buttons switches between two states, in a process of its own. It connects
 * when it reads a line, and prints how each event ended.
 */
final class RingProgram {
    static final int BUTTONS = 300;
    static final String BYPASS = "evoloop/ring/bypass";
    static final String CONTROLLER = "ring/button";

    private RingProgram() {}

    static Map<String, String> events() {
        return IntStream.range(0, BUTTONS).mapToObj(number -> "p" + number).collect(Collectors.toMap(p -> p, p -> p));
    }

    /** @param by the sender */
    static Map<String, Message> messages(String by) {
        return events().keySet().stream()
                .collect(Collectors.toMap(p -> p, p -> Message.command("ring/set", p + " " + by)));
    }

    private static StateMachine ring(String name) {
        return Machines.machine(
                name,
                IntStream.range(0, BUTTONS)
                        .boxed()
                        .flatMap(number -> Stream.of("A p" + number + " -> B", "B p" + number + " -> A"))
                        .toArray(String[]::new));
    }

    public static void main(String[] arguments) throws Exception {
        try (SystemClock clock = new SystemClock();
                BrokerConnection broker = new BrokerConnection(BrokerAddress.parse(arguments[0]), "ring-converter");
                SystemEventConverter converter = new SystemEventConverter(
                        LoopConfig.defaults("ring", clock).withQueueCapacity(100))) {
            converter.addMonitor(
                    new MqttMonitor("Buttons", broker).bypassed(BYPASS).controller(CONTROLLER, events()));
            converter.addExecute(new MqttExecute("Ring", new MqttDevice(broker, clock), messages("converted")));
            converter.addKnowledge(new StateKnowledge(new ModelPair(ring("original"), ring("new"))) {
                @Override
                protected void registerNewFunctions() {}
            });
            converter.addListener(new ConverterListener() {
                @Override
                public void ended(HistoryEntry entry) {
                    System.out.println((entry.occurrence().isFact() ? "fact " : "press ")
                            + entry.occurrence().label() + " " + entry.after().original() + " " + entry.outcome());
                }
            });
            converter.build();
            converter.start();
            System.out.println("ready");
            if (System.in.read() >= 0) {
                broker.open();
            }
            // Until the input ends.
            System.in.transferTo(OutputStream.nullOutputStream());
        }
        System.out.println("ended");
    }
}
