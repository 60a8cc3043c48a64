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
import org.evoloop.converter.EventExecute;
import org.evoloop.converter.Evolution;
import org.evoloop.converter.HistoryEntry;
import org.evoloop.converter.PushMonitor;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.evolution.Step;
import org.evoloop.evolution.Values;
import org.evoloop.loop.LoopConfig;
import org.evoloop.time.SystemClock;
import org.evoloop.time.Threads;

/**
 * The process that {@link KillTest} kills: a converter whose device is connected to its standard output, and its
 * controller to its standard input.
 */
final class KilledConverter {
    private static final PrintStream OUT = new PrintStream(System.out, true, StandardCharsets.UTF_8);
    private static final LinkedBlockingQueue<String> REPLIES = new LinkedBlockingQueue<>();

    private KilledConverter() {}

    private static final class Remote extends EventExecute {
        @Override
        protected Set<String> sendableEvents() {
            return Set.of("next");
        }

        @Override
        protected void send(Step step) throws InterruptedException {
            OUT.println("do " + step.trigger() + " " + id(values()) + " " + step.source());
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
    }

    private static int id(Values values) {
        return values.isEmpty() ? 0 : (int) values.number("id");
    }

    private static void print(HistoryEntry entry) {
        OUT.println("ended " + id(entry.occurrence().values()) + " " + entry.outcome() + " " + entry.detail());
    }

    /** @param args the directory, and when to force */
    public static void main(String[] args) throws Exception {
        LoopConfig config = LoopConfig.defaults("killed", new SystemClock())
                .withQueueCapacity(100_000)
                .withPressAge(Duration.ofDays(1));
        SystemEventConverter converter = new SystemEventConverter(config);
        Buttons buttons = new Buttons();
        converter.addMonitor(buttons);
        converter.addExecute(new Remote());
        converter.addKnowledge(new Ring(Ring.MODELS));
        converter.addKnowledgeFactory(Ring::new);
        converter.journal(Journal.in(Path.of(args[0])).withSegmentBytes(1 << 16).withForcing(Forcing.valueOf(args[1])));
        converter.addListener(new ConverterListener() {
            @Override
            public void ended(HistoryEntry entry) {
                print(entry);
            }
        });
        converter.build();
        converter.history().forEach(KilledConverter::print);
        OUT.println("model " + model(converter));
        OUT.println("doubt " + converter.status().doubt());
        converter.start();
        OUT.println("started");
        serve(converter, buttons);
        converter.close();
        System.exit(0);
    }

    private static String model(SystemEventConverter converter) {
        return converter.knowledge().models().evolved().name();
    }

    /** Evolves to the larger ring, or from there to the usual one. */
    private static void evolve(SystemEventConverter converter) {
        boolean larger = model(converter).equals(Ring.LARGER.evolved().name());
        Ring next = new Ring(larger ? Ring.MODELS : Ring.LARGER);
        OUT.println("evolving to " + next.models().evolved().name());
        converter.evolve(Evolution.to(next));
        OUT.println("model " + model(converter));
    }

    private static void serve(SystemEventConverter converter, Buttons buttons) throws Exception {
        BufferedReader in = new BufferedReader(new InputStreamReader(System.in, StandardCharsets.UTF_8));
        for (String line = in.readLine(); line != null; line = in.readLine()) {
            String[] words = line.split(" ");
            switch (words[0]) {
                case "press" -> {
                    buttons.press(words[1], Integer.parseInt(words[2]));
                    OUT.println("accepted " + words[2]);
                }
                case "evolve" -> Threads.start("evolve", () -> evolve(converter));
                case "status" ->
                    OUT.println("at " + converter.status().states().original() + " "
                            + converter.status().states().evolved() + " "
                            + converter.status().queue().depth());
                default -> REPLIES.add(words[1]);
            }
        }
    }
}
