package org.evoloop.mqtt;

import java.time.Duration;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import org.evoloop.PaperModels;
import org.evoloop.converter.DeviceLink;
import org.evoloop.converter.EventExecute;
import org.evoloop.converter.PushMonitor;
import org.evoloop.converter.StateKnowledge;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.evolution.Step;
import org.evoloop.function.Reading;
import org.evoloop.loop.LoopConfig;
import org.evoloop.time.ManualClock;

/** The light bulb's converter, with a link that can be cut. */
final class Lamp implements DeviceLink, AutoCloseable {
    final PushMonitor wallSwitch = new PushMonitor("WallSwitch");
    final ManualClock clock = new ManualClock();
    final SystemEventConverter converter = new SystemEventConverter(LoopConfig.defaults("lamp", clock));
    final List<String> sent = new CopyOnWriteArrayList<>();
    volatile boolean up = true;
    volatile long battery = 93;

    Lamp() {
        converter.addMonitor(wallSwitch);
        converter.addExecute(new EventExecute("Bulb") {
            @Override
            protected Set<String> sendableEvents() {
                return Set.of("switch");
            }

            @Override
            protected void send(Step step) {
                sent.add(step.trigger().name());
            }
        });
        converter.addKnowledge(new StateKnowledge(PaperModels.lightBulb()) {
            @Override
            protected void registerNewFunctions() {
                timer("wait", "timeout", Duration.ofSeconds(2));
                function("incandescentOn", visit -> visit.progress("warming up", List.of(Reading.of("warm", 40, "%"))));
            }
        });
        converter.addLink(this);
        converter.build();
    }

    @Override
    public boolean isUp() {
        return up;
    }

    @Override
    public String describe() {
        return up ? "in its socket" : "out of its socket";
    }

    @Override
    public List<Reading> readings() {
        return List.of(
                Reading.of("battery", battery, "%"), Reading.of("charging", false), Reading.of("mood", "it's fine"));
    }

    @Override
    public void close() {
        converter.close();
        clock.close();
    }
}
