package org.evoloop.journal;

import java.io.BufferedReader;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.LinkedBlockingQueue;
import org.evoloop.converter.ConverterListener;
import org.evoloop.converter.ConverterStatus;
import org.evoloop.converter.EventExecute;
import org.evoloop.converter.HistoryEntry;
import org.evoloop.converter.PushMonitor;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.evolution.Step;
import org.evoloop.evolution.Values;
import org.evoloop.loop.LoopConfig;
import org.evoloop.time.SystemClock;

/**
 * The process that {@link DeviceStateKillTest} kills: a converter whose device is connected to its standard output, and
 * its controller to its standard input.
 */
final class KilledAppliance {
    private static final PrintStream OUT = new PrintStream(System.out, true, StandardCharsets.UTF_8);
    private static final LinkedBlockingQueue<String> REPLIES = new LinkedBlockingQueue<>();

    private KilledAppliance() {}

    private static final class Remote extends EventExecute {
        private final Set<String> sendable;

        Remote(Set<String> sendable) {
            this.sendable = sendable;
        }

        @Override
        protected Set<String> sendableEvents() {
            return sendable;
        }

        @Override
        protected void send(Step step) throws InterruptedException {
            OUT.println("do " + step.trigger() + " " + id(values()));
            REPLIES.take();
        }

        @Override
        protected Optional<String> locate() throws InterruptedException {
            OUT.println("where");
            return Optional.of(REPLIES.take());
        }
    }

    private static final class Buttons extends PushMonitor {
        void press(String event, int id) {
            push(fromController(event, Values.of("id", id)));
        }

        void act(String event) {
            push(fromDevice(event));
        }

        /** As an adapter does that asks for the state when it connects. */
        void find(String state) {
            push(foundIn(state));
        }
    }

    private static int id(Values values) {
        return values.isEmpty() ? 0 : (int) values.number("id");
    }

    /** The states, how much is left to do, and whether the record is certain. */
    private static String now(ConverterStatus status) {
        long left = status.events().waiting() + status.events().inProgress();
        return "at " + status.states().original() + " " + status.states().evolved() + " " + left + " "
                + status.doubt().isEmpty();
    }

    /** @param args the directory, and the device */
    public static void main(String[] args) throws Exception {
        Appliance appliance = Appliance.valueOf(args[1]);
        LoopConfig config = LoopConfig.defaults("killed", new SystemClock()).withPressAge(Duration.ofDays(1));
        SystemEventConverter converter = new SystemEventConverter(config);
        Buttons buttons = new Buttons();
        converter.addMonitor(buttons);
        converter.addExecute(new Remote(appliance.sendable()));
        converter.addKnowledge(appliance.knowledge());
        converter.journal(Journal.in(Path.of(args[0])).withForcing(Forcing.PER_INTENT));
        converter.addListener(new ConverterListener() {
            @Override
            public void ended(HistoryEntry entry) {
                OUT.println("ended " + id(entry.occurrence().values()));
            }
        });
        converter.build();
        converter.start();
        OUT.println("greet");
        BufferedReader in = new BufferedReader(new InputStreamReader(System.in, StandardCharsets.UTF_8));
        for (String line = in.readLine(); line != null; line = in.readLine()) {
            String[] words = line.split(" ");
            switch (words[0]) {
                case "press" -> buttons.press(words[1], Integer.parseInt(words[2]));
                case "act" -> buttons.act(words[1]);
                case "found" -> {
                    buttons.find(words[1]);
                    OUT.println("started");
                }
                case "status" -> OUT.println(now(converter.status()));
                default -> REPLIES.add(words[1]);
            }
        }
        converter.close();
        System.exit(0);
    }
}
