package org.evoloop.models.studio;

import java.io.IOException;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Proxy;
import java.net.URI;
import java.nio.file.Path;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import org.evoloop.page.Browser;
import org.evoloop.studio.Analysis;
import org.evoloop.studio.Studio;
import org.jspecify.annotations.Nullable;

/** The studio in Chromium, used by mouse and keyboard only. */
final class StudioWindow implements AutoCloseable {
    private static final String QUIET = "document.readyState === 'complete' && !document.body.dataset.busy";

    final Browser browser;
    private @Nullable Path folder;
    private @Nullable Path tokenFile;
    private final AtomicReference<CountDownLatch> held = new AtomicReference<>(new CountDownLatch(0));
    private @Nullable Studio studio;
    private String address;

    StudioWindow(Browser browser, Path folder, Path tokenFile) throws IOException {
        this.browser = browser;
        this.folder = folder;
        this.tokenFile = tokenFile;
        studio = start(0);
        address = studio.address().toString();
    }

    /** For a studio that runs in another process. */
    StudioWindow(Browser browser, String address) {
        this.browser = browser;
        this.address = address;
    }

    private Studio start(int port) throws IOException {
        Analysis real = new StudioAnalysis();
        Analysis slow = (Analysis) Proxy.newProxyInstance(
                Analysis.class.getClassLoader(), new Class<?>[] {Analysis.class}, (proxy, method, arguments) -> {
                    if (method.getName().equals("draw")) {
                        held.get().await(60, TimeUnit.SECONDS);
                    }
                    try {
                        return method.invoke(real, arguments);
                    } catch (InvocationTargetException failure) {
                        throw failure.getCause();
                    }
                });
        return Studio.open(folder, port, tokenFile, slow);
    }

    /** Holds the pictures of all requests that come from now on, until the latch is counted down. */
    CountDownLatch hold() {
        CountDownLatch latch = new CountDownLatch(1);
        held.set(latch);
        return latch;
    }

    /** Requests that come from now on are answered at once. */
    void goOn() {
        held.set(new CountDownLatch(0));
    }

    void kill() {
        studio.close();
    }

    void startAgain() throws IOException {
        studio = start(URI.create(address).getPort());
        address = studio.address().toString();
    }

    /** What the studio prints. */
    String address() {
        return address;
    }

    /** Forgets what another test has typed, and opens the page. */
    void open() {
        browser.open(address.replaceFirst("#.*", "style.css"));
        browser.await("location.pathname === '/style.css' && document.readyState === 'complete'");
        browser.evaluate("localStorage.clear(); sessionStorage.clear()");
        openAnother();
    }

    void openAnother() {
        browser.open(address);
        browser.await("document.querySelector('#title')?.textContent !== 'Studio'");
        quiet();
    }

    /** Until the pictures show the text. */
    void quiet() {
        browser.await(QUIET);
    }

    void focus(String selector) {
        browser.evaluate("document.querySelector('" + selector + "').focus()");
    }

    static String port(String side) {
        return ".view[data-side=\"" + side + "\"] ";
    }

    private static String state(String side, String name) {
        return port(side) + ".state[data-state=\"" + name + "\"]";
    }

    void awaitState(String side, String name) {
        browser.await("document.querySelector('" + state(side, name) + "')");
        quiet();
    }

    void pick(String side, String name) {
        browser.click(port(side) + "[data-zoom=\"fit\"]");
        browser.click(state(side, name) + " .box");
        browser.await("document.querySelector('" + port(side) + ".handle')?.dataset.from === '" + name + "'");
        quiet();
    }

    /** Adds a state by the keyboard. */
    void addState(String side, String name) {
        focus(port(side) + ".port");
        browser.key("s", 83);
        browser.await("document.activeElement.id === 'new-name'");
        browser.type(name);
        browser.enter();
        awaitState(side, name);
    }

    /** Drags an arrow from the ring of a state to another state. */
    void drag(String side, String source, String target, String event) {
        drag(side, source, target, event, event);
    }

    /** @param event that the arrow has when {@code typed} is typed */
    void drag(String side, String source, String target, String typed, String event) {
        dragTo(side, source, target);
        type(side, source, target, typed, event);
    }

    /** Drags an arrow of the device's model, whose event the device raises by itself. */
    void dragOwn(String source, String target, String event) {
        dragTo("original", source, target);
        browser.click("#new-own");
        focus("#new-event");
        type("original", source, target, event, event);
    }

    private void dragTo(String side, String source, String target) {
        pick(side, source);
        browser.drag(port(side) + ".handle", state(side, target) + " .box");
        browser.await("document.activeElement.id === 'new-event'");
    }

    private void type(String side, String source, String target, String typed, String event) {
        browser.type(typed);
        browser.enter();
        awaitArrow(side, source, target, event);
    }

    void awaitArrow(String side, String source, String target, String event) {
        browser.await(
                "[...document.querySelectorAll('" + port(side) + ".event')].some(({ dataset }) => dataset.source === '"
                        + source + "' && dataset.target === '" + target + "' && dataset.event === '"
                        + event + "')");
        quiet();
    }

    /** Clicks the button of this text, as soon as it is there. */
    void button(String place, String text) {
        String it = "[...document.querySelectorAll('" + place + " button')].find(one => one.textContent === '" + text
                + "')";
        browser.await(it);
        browser.evaluate("(" + it
                + ".scrollIntoView({ block: 'nearest' }), document.querySelector('[data-here]')?.removeAttribute('data-here'), "
                + it + ".setAttribute('data-here', ''))");
        browser.click("[data-here]");
    }

    void save() {
        browser.control("s", 83);
        browser.await("document.querySelector('#unsaved').textContent === 'saved'");
    }

    String text() {
        return browser.evaluate("document.querySelector('#text').value");
    }

    /** The arrows of a picture, sorted. */
    String arrows(String side) {
        return browser.evaluate(
                "[...document.querySelectorAll('" + port(side)
                        + ".event')].map(({ dataset }) => `${dataset.source} > ${dataset.target} : ${dataset.event}`).sort().join('\\n')");
    }

    /** The states of a picture, sorted. */
    String states(String side) {
        return browser.evaluate("[...document.querySelectorAll('" + port(side)
                + ".state')].map(({ dataset }) => dataset.state).sort().join()");
    }

    @Override
    public void close() {
        held.get().countDown();
        studio.close();
    }
}
