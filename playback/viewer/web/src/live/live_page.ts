// SPDX-License-Identifier: BSD-3-Clause
import { isForPage, make } from "../elements";
import { kLooksHelp } from "../looks";
import { kOverlays } from "../overlays";
import { ShownPage } from "../shown_page";
import type { Stage } from "../stage";
import { Connection, socketUrl } from "./connection";
import { heard, type Frame, type Greeting, type Heard, type Saying } from "./messages";
import { NoteList } from "./note_list";
import { kPlanHelp } from "./plan_view";
import { Session } from "./session";
import { kTimeHelp, TimeBar } from "./time_bar";

/** A program without a message for this time has stopped. */
const kSilence_ms = 3000;
const kHelp = `${kTimeHelp} \u00b7 Shift + arrows push \u00b7 ${kPlanHelp} \u00b7 ${kLooksHelp}`;

/** The page of a live robot: it shows the program's state and sends the user's actions to the program. */
export class LivePage extends ShownPage {
  /** The first and the latest message of the program. */
  greeting: Greeting | null = null;
  frame: Frame | null = null;
  /** The program's number for this page. */
  page: number | null = null;
  session: Session | null = null;
  readonly notes = new NoteList();
  private readonly connection: Connection;
  private readonly timeBar = new TimeBar((saying) => this.send(saying));
  private readonly bar = make("div", "gw-bar");
  private readonly help = make("p", "gw-help", kHelp);
  private readonly banner = make("p", "gw-banner", "connecting");
  private greeted = "";
  private run = "";
  private lastFrame = "";

  /** @param root  its attribute `data-live` is the path of the WebSocket. */
  constructor(private readonly root: HTMLElement) {
    const overlays = kOverlays.filter((overlay) => overlay !== "footsteps" && overlay !== "swings");
    super(root, overlays, (theme) => this.session?.paint(theme));
    root.classList.add("gw-live");
    root.tabIndex = -1;
    this.bar.append(this.timeBar.root, ...this.looks.controls);
    this.banner.setAttribute("role", "alert");
    root.append(this.banner);
    this.looks.paint();
    this.connection = new Connection(socketUrl(root.dataset.live ?? ""), {
      told: (text) => this.hear(text),
      lost: () => this.lose(),
    });
    document.addEventListener("keydown", (event) => this.press(event));
    this.begin();
  }

  get connected(): boolean {
    return this.connection.connected;
  }

  /** The robot in 3D, once there is one. */
  get stage(): Stage | null {
    return this.session?.stage ?? null;
  }

  send(saying: Saying): boolean {
    return this.connection.send(saying);
  }

  protected step(now_ms: number, seconds: number): boolean {
    if (this.connected && this.greeting) this.say(this.connection.silent_ms > kSilence_ms ? "the program does not answer" : "");
    return this.session?.draw(now_ms, seconds) ?? false;
  }

  private hear(text: string): void {
    if (text === this.lastFrame) return;
    const message = this.understood(text);
    if (!message) return;
    if ("greeting" in message) this.greet(message.greeting);
    else if ("page" in message) this.number(message.page);
    else if ("frame" in message) this.take(message.frame, text);
    else this.notes.add(message.refused, "gw-refused");
  }

  /** Shows the error of an invalid message over the page, and ignores all later messages. */
  private understood(text: string): Heard | null {
    try {
      return heard(text);
    } catch (error) {
      this.greeting = null;
      this.setConnected(false);
      this.say(error instanceof Error ? error.message : String(error));
      return null;
    }
  }

  /**
   * After a lost connection, the same greeting changes nothing. If the program was restarted with the same robot,
   * controls and cameras stay.
   */
  private greet(greeting: Greeting): void {
    this.say("");
    this.greeting = greeting;
    this.lastFrame = "";
    this.setConnected(true);
    if (greeting.run !== this.run) {
      this.run = greeting.run;
      this.notes.clear();
      this.session?.beginAnew();
    }
    const robot = JSON.stringify({ ...greeting, run: "" });
    if (robot === this.greeted) return;
    this.greeted = robot;
    this.session?.dispose();
    this.session = null;
  }

  private number(page: number | null): void {
    this.page = page;
    if (this.session) this.session.page = page;
  }

  private lose(): void {
    this.say("connection lost; reconnecting");
    this.number(null);
    this.setConnected(false);
  }

  private take(frame: Frame, text: string): void {
    if (!this.greeting) return;
    this.lastFrame = text;
    this.frame = frame;
    if (this.session) this.session.take(frame);
    else this.open(this.greeting, frame);
    this.timeBar.show(frame);
    this.notes.show(frame.notes);
  }

  private open(greeting: Greeting, frame: Frame): void {
    const session = new Session(greeting, frame, (saying) => this.send(saying));
    this.session = session;
    session.page = this.page;
    session.pushes.onRefuse = (why) => this.notes.add(why, "gw-refused");
    this.stages.splice(0, 1, ...(session.stage ? [session.stage] : []));
    const controls = make("div", "gw-controls");
    controls.append(session.tabs.root, this.notes.root);
    this.root.replaceChildren(this.banner, session.stageBox, this.bar, this.looks.legend, controls, session.plots, this.help);
    this.looks.apply();
  }

  private setConnected(connected: boolean): void {
    this.timeBar.root.inert = !connected;
    this.session?.setConnected(connected);
  }

  /** Shows an error over the page; an empty text removes it. */
  private say(text: string): void {
    if (this.banner.textContent === text) return;
    this.banner.textContent = text;
    this.banner.hidden = text === "";
    this.root.classList.toggle("gw-lost", text !== "");
  }

  private press(event: KeyboardEvent): void {
    if (!isForPage(event)) return;
    const asked = this.connected && this.greeting && (this.timeBar.press(event) || this.session?.pushes.press(event));
    const done = asked || this.session?.plan.press(event.key) || this.looks.press(event.key);
    if (done) event.preventDefault();
  }
}
