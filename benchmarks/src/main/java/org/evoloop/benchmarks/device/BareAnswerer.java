package org.evoloop.benchmarks.device;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicLong;
import org.evoloop.benchmarks.ring.HandOff;
import org.evoloop.link.Link;
import org.evoloop.roomba.oi.Command;
import org.evoloop.roomba.oi.InputCommand;
import org.evoloop.roomba.oi.Packet;
import org.evoloop.time.Clock;

/** Threads that only wake each other: the first reads, the last writes, and none decides anything. */
final class BareAnswerer implements Answerer {
    private static final int BUFFER_BYTES = 1_024;
    private static final byte BUTTONS = (byte) Packet.BUTTONS.id();
    private static final byte[] CLEAN = new Command.Clean().bytes();
    private static final byte[] SAFE = new Command.Safe().bytes();

    private final Link link;
    private final HandOff[] slots;
    private final List<Thread> threads = new ArrayList<>();
    private final AtomicLong answered = new AtomicLong();

    /** @param relays how many threads pass a press on between the one that reads and the link */
    BareAnswerer(Link link, int relays, Clock clock) throws InterruptedException {
        this.link = link;
        this.slots = new HandOff[relays];
        for (int index = 0; index < relays; index++) {
            int mine = index;
            slots[index] = HandOff.Kind.PARKING_SLOT.make();
            start("bare-relay-" + index, () -> relay(mine));
        }
        start("bare-reader", this::read);
        for (Command command :
                List.of(new Command.Start(), new Command.Safe(), new InputCommand.Stream(List.of(Packet.BUTTONS)))) {
            link.send(command.bytes());
            clock.sleep(PressToCommand.REST);
        }
    }

    private void start(String name, Runnable task) {
        Thread thread = new Thread(task, name);
        thread.setDaemon(true);
        threads.add(thread);
        thread.start();
    }

    private void read() {
        byte[] buffer = new byte[BUFFER_BYTES];
        byte before = 0;
        boolean held = false;
        for (int length = link.receive(buffer); length > 0; length = link.receive(buffer)) {
            for (int index = 0; index < length; index++) {
                if (before == BUTTONS) {
                    if (buffer[index] != 0 && !held) {
                        pass(answered.get() % 2 == 0 ? CLEAN : SAFE, 0);
                    }
                    held = buffer[index] != 0;
                }
                before = buffer[index];
            }
        }
    }

    private void pass(byte[] answer, int to) {
        try {
            if (to < slots.length) {
                slots[to].give(answer);
            } else {
                link.send(answer);
                answered.incrementAndGet();
            }
        } catch (InterruptedException closing) {
            Thread.currentThread().interrupt();
        }
    }

    private void relay(int mine) {
        try {
            while (!Thread.currentThread().isInterrupted()) {
                pass((byte[]) slots[mine].take(), mine + 1);
            }
        } catch (InterruptedException closing) {
            Thread.currentThread().interrupt();
        }
    }

    @Override
    public long answered() {
        return answered.get();
    }

    @Override
    public void close() {
        link.close();
        threads.forEach(Thread::interrupt);
    }
}
