// A student's lines: read, refused where they say more than lines may, made to stop, and made to tell their values. Runs in a
// worker beside acorn, and in Node. The text is cut and joined, so that lines and columns stay what the student sees.

/** @typedef {{line: number, column: number, text: string}} Complaint */

const kMostText = 10000;  // characters
const kGivenWords = 'dot cross length normalize sqrt pow abs min max floor round sin cos tan radians';
// Beside these, lines may use what they declare themselves. Nothing outside can be reached, in whatever program they run;
// the worker and the page's policy are the second wall.
const kKnownNames = new Set((kGivenWords + ' Math Infinity NaN undefined').split(' '));
const kMembers = new Set('length map push pop slice reduce forEach filter some every sort reverse indexOf includes'.split(' '));
const kNodes = new Set(('Program FunctionDeclaration FunctionExpression ArrowFunctionExpression BlockStatement ReturnStatement IfStatement ForStatement '
  + 'ForOfStatement WhileStatement DoWhileStatement BreakStatement ContinueStatement EmptyStatement ExpressionStatement VariableDeclaration '
  + 'VariableDeclarator Identifier Literal ArrayExpression ObjectExpression Property ArrayPattern ObjectPattern RestElement AssignmentPattern '
  + 'SpreadElement UnaryExpression BinaryExpression LogicalExpression ConditionalExpression AssignmentExpression UpdateExpression CallExpression '
  + 'MemberExpression SequenceExpression').split(' '));
const kWordOf = { TryStatement: 'try', ThrowStatement: 'throw', NewExpression: 'new', ThisExpression: 'this', ClassDeclaration: 'class', TemplateLiteral: 'a text',
  ImportExpression: 'import', ImportDeclaration: 'import', WithStatement: 'with', SwitchStatement: 'switch', AwaitExpression: 'await', YieldExpression: 'yield',
  LabeledStatement: 'a label', ForInStatement: 'for … in', ChainExpression: '?.', MetaProperty: 'import.meta', TaggedTemplateExpression: 'a text' };
const kVectorOperators = { '+': '$add', '-': '$sub', '*': '$mul', '/': '$div' };
const kComparisons = ['<', '<=', '>', '>=', '===', '!==', '==', '!='];
const kMakesLists = ['map', 'slice', 'filter'];  // members whose result is a new list

const childrenOf = node => Object.entries(node).flatMap(([key, value]) => (key === 'loc' ? [] : (Array.isArray(value) ? value : [value]).filter(child => child?.type).map(child => ({ key, child }))))
  .sort((a, b) => a.child.start - b.child.start);
/** The names that a pattern declares, or that an assignment changes. @returns {string[]} */
const namesIn = pattern => {
  switch (pattern?.type) {
    case 'Identifier': return [pattern.name];
    case 'MemberExpression': return namesIn(pattern.object);
    case 'AssignmentPattern': return namesIn(pattern.left);
    case 'RestElement': return namesIn(pattern.argument);
    case 'ArrayPattern': return pattern.elements.flatMap(namesIn);
    case 'ObjectPattern': return pattern.properties.flatMap(property => namesIn(property.value ?? property));
    default: return [];
  }
};

/** The nearest word, or '' where none is near. @param {string} name @param {Iterable<string>} words */
function nearest(name, words) {
  const distance = (a, b) => {
    let row = Array.from({ length: b.length + 1 }, (_, i) => i);
    for (let i = 1; i <= a.length; ++i) {
      const next = [i];
      for (let k = 1; k <= b.length; ++k) next[k] = Math.min(row[k] + 1, next[k - 1] + 1, row[k - 1] + Number(a[i - 1] !== b[k - 1]));
      row = next;
    }
    return row[b.length];
  };
  const [best] = [...words].map(word => ({ word, off: distance(name.toLowerCase().slice(0, 40), word.toLowerCase()) })).sort((a, b) => a.off - b.off);
  return best && best.off <= Math.max(1, name.length / 3) ? best.word : '';
}

/** Complains about all that lines may not use. @param {any} tree @param {(node: any, text: string) => void} complain */
function checkLines(tree, complain) {
  const declared = new Set();
  const each = (node, work, parent = null, key = '') => {
    work(node, parent, key);
    for (const part of childrenOf(node)) each(part.child, work, node, part.key);
  };
  each(tree, node => {
    if (node.type === 'VariableDeclarator') namesIn(node.id).forEach(name => declared.add(name));
    if (/Function/.test(node.type)) [...namesIn(node.id), ...node.params.flatMap(namesIn)].forEach(name => declared.add(name));
  });
  for (const name of declared) if (name[0] === '$' || ['Math', 'arguments', 'eval'].includes(name)) complain(tree, `${name} cannot be a name here`);
  each(tree, (node, parent, key) => {
    if (!kNodes.has(node.type)) return complain(node, `${kWordOf[node.type] || node.type} is not there`);
    if (node.async || node.generator || node.await) return complain(node, 'async and function* are not there');
    if (node.type === 'Literal' && (node.regex || (!['number', 'boolean'].includes(typeof node.value) && node.value !== null)))
      return complain(node, node.regex ? 'a regular expression is not there' : 'a text is not there: lines compute with numbers');
    if (node.type === 'UnaryExpression' && !['-', '+', '!'].includes(node.operator)) return complain(node, `${node.operator} is not there`);
    if (node.type === 'BinaryExpression' && ['in', 'instanceof'].includes(node.operator)) return complain(node, `${node.operator} is not there`);
    if (node.type === 'MemberExpression' && !node.computed && !kMembers.has(node.property.name)
      && !(node.object.name === 'Math' && Object.hasOwn(Math, node.property.name))) return complain(node.property, `.${node.property.name} is not there`);
    if (node.type === 'Property' && (node.computed || node.kind !== 'init' || node.method || !/^[a-z]\w*$/i.test(node.key.name ?? '')
      || /^(__proto__|constructor|then|toString|valueOf|toJSON)$/.test(node.key.name))) return complain(node, 'this field is not there');
    if (node.type !== 'Identifier' || (parent.type === 'MemberExpression' && key === 'property' && !parent.computed) || (parent.type === 'Property' && key === 'key')) return undefined;
    if (declared.has(node.name) || kKnownNames.has(node.name)) return undefined;
    const near = nearest(node.name, [...declared, ...kKnownNames]);
    return complain(node, `there is no ${node.name} here${near ? `: do you mean ${near}?` : ''}`);
  });
}

/** The text of an expression whose value is the function `name`, made to stop; traced: made to tell its values too.
 * @param {string} text @param {any} tree @param {string} name @param {boolean} traced */
function rewritten(text, tree, name, traced) {
  let depth = 0;  // of functions
  const line = node => node.loc.start.line;
  /** The text of a node with its parts written anew, up to the part `end`. */
  const plain = (node, end = null) => {
    let out = '', at = node.start;
    for (const { child } of childrenOf(node)) {
      if (child === end) return out + text.slice(at, child.start);
      if (child.start < at) continue;  // a shorthand property is its own value
      out += text.slice(at, child.start) + written(child), at = child.end;
    }
    return out + text.slice(at, node.end);
  };
  const ended = code => code.replace(/;?\s*$/, ';');
  const told = (node, list, part = '') => (traced && depth && list.length ? `$line(${line(node)},{${[...new Set(list)].join()}${part ? `,${JSON.stringify(part)}:${part}` : ''}});` : '');
  const body = node => (node.type === 'BlockStatement' ? plain(node).slice(1, -1) : written(node));
  const tested = ({ loc, test }) => {
    if (!traced) return written(test);
    return test.type === 'BinaryExpression' && kComparisons.includes(test.operator)
      ? `$compare(${loc.start.line},${written(test.left)},"${test.operator}",${written(test.right)})` : `$test(${loc.start.line},${written(test)})`;
  };
  const written = node => (node.turn ? `($turn(${node.turn}),${anew(node)})` : anew(node));
  function anew(node) {
    switch (node.type) {
      case 'ArrayExpression': return `$list(${plain(node)})`;
      case 'BinaryExpression': return kVectorOperators[node.operator] ? `${kVectorOperators[node.operator]}(${written(node.left)},${written(node.right)})` : plain(node);
      case 'UnaryExpression': return node.operator === '-' && node.argument.type !== 'Literal' ? `$neg(${written(node.argument)})` : plain(node);
      case 'MemberExpression': return node.computed ? `${written(node.object)}[$index(${written(node.property)})]` : plain(node);
      case 'CallExpression': {
        const member = node.callee.type === 'MemberExpression' && !node.callee.computed ? node.callee.property.name : '';
        if (member === 'push') return `$push(${[node.callee.object, ...node.arguments].map(written).join()})`;
        return kMakesLists.includes(member) ? `$list(${plain(node)})` : plain(node);
      }
      case 'AssignmentExpression': {
        const operator = node.operator.length === 2 ? kVectorOperators[node.operator[0]] : undefined;
        return operator ? `${written(node.left)}=${operator}(${written(node.left)},${written(node.right)})` : plain(node);
      }
      case 'ExpressionStatement': {
        const { expression } = node, isAssigned = expression.type === 'AssignmentExpression';
        const changed = isAssigned ? namesIn(expression.left) : expression.type === 'UpdateExpression' ? namesIn(expression.argument)
          : expression.callee?.type === 'MemberExpression' && expression.callee.object.name !== 'Math' ? namesIn(expression.callee.object) : [];
        const part = isAssigned && expression.left.type === 'MemberExpression' ? text.slice(expression.left.start, expression.left.end) : '';
        return `{(${written(expression)});${told(node, changed, part)}}`;
      }
      case 'VariableDeclaration':
        if (node.isHead) return plain(node);
        return ended(plain(node)) + told(node, node.declarations.filter(one => one.init && !/Function/.test(one.init.type)).flatMap(one => namesIn(one.id)));
      case 'SequenceExpression': return `(${plain(node)})`;
      case 'ReturnStatement': return node.argument && traced ? `return $back(${line(node)},${written(node.argument)});` : ended(plain(node));
      case 'IfStatement': return `if(${tested(node)}){${body(node.consequent)}}${node.alternate ? `else{${body(node.alternate)}}` : ''}`;
      case 'ConditionalExpression': return `(${tested(node)}?${written(node.consequent)}:${written(node.alternate)})`;
      case 'DoWhileStatement': return `do{$turn(${line(node)});${body(node.body)}}while(${written(node.test)});`;
      case 'ForStatement': case 'WhileStatement': case 'ForOfStatement': {
        const head = node.init ?? node.left;
        if (head) head.isHead = true;
        return `${plain(node, node.body)}{$turn(${line(node)});${told(node, head?.declarations?.flatMap(one => namesIn(one.id)) ?? [])}${body(node.body)}}`;
      }
      case 'FunctionDeclaration': case 'FunctionExpression': case 'ArrowFunctionExpression': {
        ++depth;
        const names = node.id?.name === name ? told(node, node.params.flatMap(namesIn)) : '';
        if (node.body.type !== 'BlockStatement') node.body.turn = line(node);
        const code = node.body.turn ? plain(node) : `${plain(node, node.body)}{$turn(${line(node)});${names}${body(node.body)}}`;
        --depth;
        return code;
      }
      default: return plain(node);
    }
  }
  return `(function(){"use strict";${plain(tree)}\nreturn ${name};})()`;
}

/** @param {string} text @param {string} name of the function @param {(text: string, options: any) => any} parse acorn's
 * @returns {{errors: Complaint[], plain: string, traced: string}} */
function readLines(text, name, parse) {
  /** @type {Complaint[]} */
  const errors = [], found = () => ({ errors, plain: '', traced: '' });
  const complain = (node, words) => errors.push({ line: node.loc.start.line, column: node.loc.start.column + 1, text: words });
  if (text.length > kMostText) return errors.push({ line: 1, column: 1, text: `more than ${kMostText} characters` }), found();
  try {
    const tree = parse(text, { ecmaVersion: 2022, locations: true });
    checkLines(tree, complain);
    const isThere = tree.body.some(node => (node.type === 'FunctionDeclaration' && node.id.name === name) || node.declarations?.some(one => one.id.name === name));
    if (!isThere) errors.push({ line: 1, column: 1, text: `there is no function ${name}` });
    return errors.length ? found() : { errors, plain: rewritten(text, tree, name, false), traced: rewritten(text, tree, name, true) };
  } catch (error) {
    const isDeep = error instanceof RangeError || !error.loc;
    errors.push({ line: error.loc?.line ?? 1, column: (error.loc?.column ?? 0) + 1, text: isDeep ? 'too many brackets within one another' : error.message.replace(/ \(\d+:\d+\)$/, '') });
    return found();
  }
}
