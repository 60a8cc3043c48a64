package org.evoloop.mqtt.home;

import java.net.URI;
import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Function;
import org.evoloop.console.Console;
import org.evoloop.console.OfferedModels;
import org.evoloop.converter.ConverterListener;
import org.evoloop.converter.ConverterStatus;
import org.evoloop.converter.Evolution;
import org.evoloop.converter.HistoryEntry;
import org.evoloop.converter.PushMonitor;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.EventOutcome;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Outcome;
import org.evoloop.evolution.Values;
import org.evoloop.function.Reading;
import org.evoloop.loop.Failure;
import org.evoloop.loop.LoopState;
import org.evoloop.mqtt.BrokerAddress;
import org.evoloop.mqtt.BrokerConnection;
import org.evoloop.mqtt.Message;
import org.evoloop.mqtt.Told;
import org.evoloop.payload.JsonObject;
import org.evoloop.statemachine.State;
import org.evoloop.time.Threads;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Shows and operates a converter in Home Assistant: one device with the states of both models, the events and their
 * outcomes, buttons for the controller's events, the readings of the device, and the converter's diagnostics.
 *
 * <pre>{@code
 * HomeAssistant home = new HomeAssistant(console, BrokerAddress.parse("mqtt://ha@broker")).open();
 * console.onEnd(reason -> home.close());
 * }</pre>
 *
 * <p>Lifecycle: made when the converter has been built; {@link #entity} and {@link #choice}; {@link #open}, which does
 * not wait for the broker; {@link #close}, after which the device is unavailable.
 *
 * <p>Threading: {@link #open} and what comes before on one thread. The converter's threads never wait for the broker.
 *
 * @since 0.1
 */
public final class HomeAssistant implements AutoCloseable {
    private static final Logger LOG = LoggerFactory.getLogger(HomeAssistant.class);
    private static final long LOOK_MILLIS = 500;
    private static final int MOST_COMMANDS = 64;
    private static final Duration END_LIMIT = Duration.ofSeconds(2);

    private final SystemEventConverter converter;
    private final HomeTopics topics;
    private final BrokerConnection connection;
    private final PushMonitor controller = new PushMonitor("HomeAssistant");
    private final LinkedBlockingQueue<Runnable> inbox = new LinkedBlockingQueue<>(MOST_COMMANDS);
    private final List<Choice> choices = new ArrayList<>();
    private final HomeSettings settings = new HomeSettings();
    /** All readings so far: an entity remains while its device cannot be reached. */
    private final Set<HomeReading> readings = new LinkedHashSet<>();

    private final AtomicBoolean promoting = new AtomicBoolean();
    private boolean described;
    /** Whether there has been a shadow: its entities remain after it. */
    private boolean shadowed;

    private final List<HomeEntity> entities = new ArrayList<>();
    private final HomeOperator operator;
    private final Optional<OfferedModels> offered;
    private boolean reached = true;
    private HomePictures pictures;

    private @Nullable URI page;
    private @Nullable Thread thread;
    private volatile String lastFailure = "";

    /** Shows a console's converter there, and lets one of the {@linkplain OfferedModels models that it offers} be chosen. */
    public HomeAssistant(Console console, BrokerAddress address) {
        this(console.converters().get(0), address, console.offeredModels());
        page = console.page().orElse(null);
        offered.filter(offered -> offered.references().size() > 1)
                .map(offered -> Choice.among(offered, converter))
                .ifPresent(choices::add);
    }

    /**
     * Prepares to show {@code converter}.
     *
     * @param converter built
     */
    public HomeAssistant(SystemEventConverter converter, BrokerAddress address) {
        this(converter, address, Optional.empty());
    }

    private HomeAssistant(SystemEventConverter converter, BrokerAddress address, Optional<OfferedModels> offered) {
        this.offered = offered;
        this.pictures = new HomePictures(models -> "", Optional.empty());
        this.converter = converter;
        this.topics = new HomeTopics(address.id(converter.status().name()), address.discovery());
        this.connection = new BrokerConnection(address, "evoloop-" + topics.id());
        this.operator = new HomeOperator(converter, this::submit, this::refuse);
    }

    /** Shows an entity as well, such as a cover; before {@link #open}. */
    public HomeAssistant entity(HomeEntity shown) {
        entities.add(shown);
        return this;
    }

    /** Adds a choice; before {@link #open}. */
    public HomeAssistant choice(Choice offered) {
        choices.add(offered);
        return this;
    }

    /** Adds something that can be set; before {@link #open}. */
    public HomeAssistant setting(HomeSetting setting) {
        settings.add(setting);
        return this;
    }

    /**
     * Shows pictures of the new models: of the one that runs, and of those that can be chosen; before {@link #open}.
     *
     * @param draw the new model of a pair as SVG; empty for one that cannot be drawn
     */
    public HomeAssistant pictures(Function<ModelPair, String> draw) {
        pictures = new HomePictures(draw, offered);
        return this;
    }

    /** Starts connecting and showing the converter. */
    public HomeAssistant open() {
        converter.addMonitor(controller);
        converter.addListener(new Listener());
        connection.will(Message.state(topics.availability(), "offline"));
        connection.subscribe(topics.birth(), message -> {
            if (message.payload().equals("online")) {
                connection.republish();
            }
        });
        obey(topics.press(), this::press);
        obey(topics.converting(), this::convert);
        obey(topics.promote(), this::beginPromotion);
        entities.forEach(this::obey);
        obeySettings();
        for (Choice choice : choices) {
            obey(topics.choice(choice.key()), wanted -> {
                if (!choice.options().contains(wanted)) {
                    throw new IllegalArgumentException("there is no " + choice.name() + " " + wanted);
                }
                choice.choose().accept(wanted);
            });
        }
        thread = new Thread(this::run, "mqtt-home-" + topics.id());
        thread.setDaemon(true);
        thread.start();
        connection.open();
        return this;
    }

    private void obeySettings() {
        settings.begin();
        if (settings.all().isEmpty()) {
            return;
        }
        for (HomeSetting setting : settings.all()) {
            if (setting.isSet()) {
                obey(topics.setting(setting.key()), wanted -> keep(settings.set(setting, wanted)));
            }
        }
        connection.subscribe(topics.settings(), message -> {
            if (message.kind() == Message.Kind.STATE) {
                keep(settings.restore(message.payload()));
                look();
            }
        });
    }

    private void keep(String values) {
        if (!values.isEmpty()) {
            publish(Message.state(topics.settings(), values));
        }
    }

    private void obey(HomeEntity entity) {
        String key = entity.key();
        if (entity.kind() == HomeKind.EVENT) {
            return;
        }
        obey(topics.command(key), payload -> operator.obey(entity, HomeNative.command(entity, payload)));
        if (entity.kind().hasModes()) {
            obey(topics.mode(key), mode -> operator.obey(entity, entity.kind().modeWord() + " " + mode));
        }
        if (entity.kind() == HomeKind.HUMIDIFIER) {
            obey(topics.humidity(key), wanted -> {
                throw new IllegalStateException(
                        "the humidity that is wanted is not something that the new model knows");
            });
        }
    }

    /** Wakes this thread when the outcome is known. */
    private CompletableFuture<EventOutcome> submit(String event) {
        return Told.submit(controller, event, Values.NONE, connection, topics.outcome())
                .whenComplete((outcome, never) -> look());
    }

    private void press(String event) {
        EventOutcome early = submit(event).getNow(null);
        if (early instanceof EventOutcome.Refused || early instanceof EventOutcome.Dropped) {
            throw new IllegalStateException(early.why());
        }
    }

    private void convert(String payload) {
        switch (payload) {
            case "ON" -> converter.start();
            case "OFF" -> converter.stop();
            default -> throw new IllegalArgumentException("converting is ON or OFF, not " + payload);
        }
    }

    /** It waits until it is possible, and other commands do not wait for it. */
    private void beginPromotion(String payload) {
        if (!promoting.compareAndSet(false, true)) {
            throw new IllegalStateException("the shadow is already being promoted");
        }
        Threads.start("mqtt-promote-" + topics.id(), () -> {
            try {
                obey(any -> promote(), payload);
            } finally {
                promoting.set(false);
            }
        });
    }

    private void promote() {
        converter
                .shadow()
                .orElseThrow(() -> new IllegalStateException("there is no shadow"))
                .promote();
    }

    /** The action of a command. */
    private interface Action {
        void obey(String payload) throws Exception;
    }

    private void obey(String topic, Action action) {
        connection.subscribe(topic, message -> {
            String payload = message.payload();
            if (message.kind() == Message.Kind.STATE) {
                LOG.warn(
                        "the command '{}' on {} was retained by the broker, so it is old and ignored; publish it "
                                + "without retain",
                        payload,
                        topic);
            } else if (!inbox.offer(() -> obey(action, payload))) {
                LOG.warn("more than {} commands wait; '{}' on {} is ignored", MOST_COMMANDS, payload, topic);
            }
        });
    }

    private void obey(Action action, String payload) {
        try {
            action.obey(payload);
        } catch (InterruptedException end) {
            Thread.currentThread().interrupt();
        } catch (Exception refusal) {
            String why = String.valueOf(refusal.getMessage());
            LOG.debug("'{}' is refused", payload, refusal);
            refuse(payload, why);
        }
    }

    private void refuse(String command, String why) {
        publish(Message.event(topics.decision(), HomeState.refusal(command, why).toString()));
        fail(HomeDiscovery.REFUSED, command + ": " + why);
    }

    /** Raises the event that something has failed. */
    private void fail(String type, String what) {
        publish(Message.event(topics.failure(), HomeState.failure(type, what).toString()));
    }

    private void run() {
        try {
            while (!Thread.currentThread().isInterrupted()) {
                show();
                operator.proceed();
                Runnable next = inbox.poll(LOOK_MILLIS, TimeUnit.MILLISECONDS);
                for (; next != null; next = inbox.poll()) {
                    next.run();
                }
            }
        } catch (InterruptedException end) {
            // It is being closed.
        }
    }

    private void show() {
        ConverterStatus status = converter.status();
        JsonObject shadow = converter.shadow().map(HomeState::shadow).orElse(HomeState.NO_SHADOW);
        boolean more = !described;
        if (shadow != HomeState.NO_SHADOW && !shadowed) {
            shadowed = true;
            more = true;
        }
        for (Reading reading : HomeState.readings(status)) {
            more |= readings.add(HomeReading.of(reading));
        }
        if (more) {
            described = true;
            publish(Message.state(topics.config(), config(status)));
        }
        publish(Message.state(
                topics.state(),
                HomeState.state(status, choices, settings.shown(), lastFailure).toString()));
        for (HomeEntity entity : entities) {
            if (entity.kind() != HomeKind.EVENT && entity.kind() != HomeKind.BUTTON) {
                publish(Message.state(
                        topics.entity(entity.key()),
                        HomeNative.published(entity, operator.table(entity), status)
                                .toString()));
            }
        }
        lookAtLink(status);
        if (shadowed) {
            publish(Message.state(topics.shadow(), shadow.toString()));
        }
        publish(Message.state(
                topics.diagnostics(), HomeState.diagnostics(status, connection).toString()));
        boolean ended = status.loop() == LoopState.EXITED;
        publish(Message.state(topics.availability(), ended ? "offline" : "online"));
    }

    private void lookAtLink(ConverterStatus status) {
        ConverterStatus.LinkStatus link = status.link();
        if (link != null && !link.up() && reached) {
            fail(HomeDiscovery.UNREACHABLE, link.text());
        }
        reached = link == null || link.up();
    }

    private String config(ConverterStatus status) {
        HomeDiscovery discovery = new HomeDiscovery(topics, status.name())
                .converter(converter.knowledge().models(), operator.buttons(), !entities.isEmpty());
        entities.forEach(entity -> discovery.entity(entity, operator.table(entity)));
        if (status.link() != null) {
            discovery.link();
        }
        if (shadowed) {
            discovery.shadow();
        }
        readings.forEach(discovery::reading);
        choices.forEach(discovery::choice);
        settings.all().forEach(discovery::setting);
        pictures.of(converter.knowledge().models()).forEach(picture -> {
            discovery.picture(picture.key(), picture.title());
            publish(Message.state(topics.picture(picture.key()), picture.svg()));
        });
        return discovery.payload(page);
    }

    private void publish(Message message) {
        connection.publish(message);
    }

    /** Wakes the thread, if it has nothing to do anyway. */
    private void look() {
        inbox.offer(() -> {});
    }

    private final class Listener implements ConverterListener {
        @Override
        public void ended(HistoryEntry entry) {
            if (entry.occurrence() instanceof Occurrence.Violated violated) {
                lastFailure = violated.label();
            }
            publish(Message.event(topics.decision(), HomeState.decision(entry).toString()));
            if (entry.outcome() == Outcome.FAILED) {
                fail(HomeDiscovery.FAILED, entry.occurrence().label() + ": " + entry.detail());
            }
            raise(entry);
            look();
        }

        /** The types of the event entities, when their state is entered. */
        private void raise(HistoryEntry entry) {
            State now = entry.after().evolved();
            for (HomeEntity entity : entities) {
                String type = entity.kind() == HomeKind.EVENT
                                && !now.equals(entry.before().evolved())
                        ? operator.table(entity).mode(now)
                        : "";
                if (!type.isEmpty()) {
                    publish(Message.event(
                            topics.entity(entity.key()),
                            new JsonObject().put("event_type", type).toString()));
                }
            }
        }

        @Override
        public void moved(Configuration before, Configuration after) {
            look();
        }

        @Override
        public void evolved(Evolution.Result result) {
            // Other states are possible, and other buttons.
            inbox.offer(() -> described = false);
        }

        @Override
        public void failed(Failure<Occurrence> failure) {
            lastFailure = failure.toString();
            look();
        }
    }

    /** Announces that the converter is gone, and ends. Idempotent. */
    @Override
    public void close() {
        Thread running = thread;
        if (running != null) {
            running.interrupt();
            Threads.join(running, END_LIMIT);
        }
        connection.close();
    }
}
